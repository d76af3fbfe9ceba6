#include "client/cells/cell_creases.hpp"

#include <algorithm>
#include <tuple>

#include "common/base/small_count.hpp"

namespace spoctree {

CellCreases::CellCreases(const EmptySpace& space, std::span<const Crease> creases, double reach,
                         const ProgressShare& progress) {
  struct Touch {
    std::uint32_t cell;
    CreasePart part;
  };
  std::vector<Touch> touches;
  ProgressCounter counter(progress);
  for (std::uint32_t number = 0; number < creases.size(); ++number) {
    counter.add(per_item(creases.size()));
    space.for_each_cell_of(creases[number], number, reach,
                           [&](std::uint32_t cell, const CreasePart& part) {
                             small_count(touches.size() + 1, "parts of creases at cells");
                             touches.push_back({cell, part});
                           });
  }
  counter.tell();
  std::sort(touches.begin(), touches.end(), [](const Touch& p, const Touch& q) {
    return std::tuple(p.cell, p.part.crease, p.part.interval.begin, p.part.interval.end) <
           std::tuple(q.cell, q.part.crease, q.part.interval.begin, q.part.interval.end);
  });
  begin_.assign(space.cells().size() + 1, 0);
  for (std::size_t k = 0; k < touches.size();) {
    // A convex cell touches one stretch: what several parts of a merged one do is one.
    Touch merged = touches[k];
    for (++k; k < touches.size() && touches[k].cell == merged.cell &&
              touches[k].part.crease == merged.part.crease;
         ++k) {
      merged.part.interval.end = std::max(merged.part.interval.end, touches[k].part.interval.end);
    }
    parts_.push_back(merged.part);
    ++begin_[merged.cell + 1];
  }
  for (std::size_t cell = 0; cell + 1 < begin_.size(); ++cell) begin_[cell + 1] += begin_[cell];
}

}  // namespace spoctree
