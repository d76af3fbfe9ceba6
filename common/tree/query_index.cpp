#include "common/tree/query_index.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "common/geometry/predicates.hpp"

namespace spoctree {

namespace {
/// The octant that coordinates with `bit` set or not lie in.
std::uint32_t octant_of(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t bit) {
  return ((x & bit) != 0 ? 1u : 0u) | ((y & bit) != 0 ? 2u : 0u) | ((z & bit) != 0 ? 4u : 0u);
}
}  // namespace

QueryIndex::QueryIndex(const Octree& tree, std::uint32_t level)
    : tree_(&tree),
      level_(std::min(level, static_cast<std::uint32_t>(tree.levels.size() - 1))),
      rounding_(coordinate_rounding(tree.universe)),
      graph_(make_decision_graph(tree, level_)) {
  while ((std::size_t{8} << (3 * entry_depth_)) <= graph_.cells.size()) ++entry_depth_;
  const std::uint32_t side = 1u << entry_depth_;
  entries_.reserve(std::size_t{side} * side * side);
  for (std::uint32_t z = 0; z < side; ++z) {
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t x = 0; x < side; ++x) {
        Entry entry{graph_.root, std::uint32_t{1} << kMaxDepth};
        std::uint32_t bit = side;
        while ((bit /= 2) > 0 && DecisionGraph::is_cell(entry.step)) {
          entry.step = graph_.cell(entry.step)[octant_of(x, y, z, bit)];
          entry.size /= 2;
        }
        entries_.push_back(entry);
      }
    }
  }
}

PointClass QueryIndex::classify(Vec3 point) const {
  const double half_side = tree_->universe.half_side;
  const double finest_per_unit = 0x1p29 / half_side;
  const auto ask_exactly = [&] { return classify_point(*tree_, point, level_); };
  // The finest cell that the point lies in, and which of that cell's lower walls it lies on.
  std::uint32_t cell[3];
  bool on_wall[3];
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const double y = point[static_cast<int>(axis)];
    if (!(std::abs(y) < half_side)) {
      return std::abs(y) == half_side ? ask_exactly() : PointClass::Out;
    }
    auto index = static_cast<std::uint32_t>((y + half_side) * finest_per_unit);
    while (y < wall_coordinate(half_side, index)) --index;
    while (y >= wall_coordinate(half_side, index + 1)) ++index;
    cell[axis] = index;
    on_wall[axis] = y == wall_coordinate(half_side, index);
  }
  const std::uint32_t shift = static_cast<std::uint32_t>(kMaxDepth) - entry_depth_;
  const std::size_t entry = (std::size_t{cell[2] >> shift} << (2 * entry_depth_)) |
                            (std::size_t{cell[1] >> shift} << entry_depth_) | (cell[0] >> shift);
  auto [step, size] = entries_[entry];
  while (!DecisionGraph::is_answer(step)) {
    if (DecisionGraph::is_test(step)) {
      const PlaneTest& test = graph_.test(step);
      const Plane& plane = tree_->planes[test.plane];
      const double value = glm::dot(plane.normal, point) - plane.offset;
      int side = value < 0 ? -1 : 1;
      if (std::abs(value) <= kSideError) {
        side = side_of_any_point(plane, point);
        if (side == 0) return ask_exactly();
      }
      step = side < 0 ? test.inside : test.outside;
    } else {
      size /= 2;
      step = graph_.cell(step)[octant_of(cell[0], cell[1], cell[2], size)];
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (on_wall[axis] && (cell[axis] & (size - 1)) == 0) return ask_exactly();
  }
  constexpr PointClass kAnswers[] = {PointClass::Out, PointClass::In, PointClass::Unknown};
  return kAnswers[step];
}

}  // namespace spoctree
