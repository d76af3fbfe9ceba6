#include "client/rebuild/line_ends.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "common/base/parallel.hpp"
#include "common/geometry/predicates.hpp"

namespace spoctree {

namespace {

/// What one corner says on its three lines; `vertex` is the corner's. From three faces in
/// counter-clockwise order, the edge of the first on the line with the second ends in the corner.
void append_ends(const CornerCount& corner, const std::uint32_t (&carriers)[3],
                 std::uint32_t vertex, std::vector<LineEnd>& ends) {
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t a = carriers[i];
    const std::uint32_t b = carriers[(i + 1) % 3];
    ends.push_back(a < b ? LineEnd{a, b, vertex, corner.count}
                         : LineEnd{b, a, vertex, -corner.count});
  }
}

/// Sorts the ends of one vertex and adds up those on one line.
void sum_up(std::vector<LineEnd>& ends, std::vector<LineEnd>& result) {
  std::sort(ends.begin(), ends.end(), [](const LineEnd& e, const LineEnd& f) {
    return std::tie(e.low, e.high) < std::tie(f.low, f.high);
  });
  for (std::size_t i = 0; i < ends.size();) {
    LineEnd sum = ends[i];
    for (++i; i < ends.size() && ends[i].low == sum.low && ends[i].high == sum.high; ++i) {
      sum.count += ends[i].count;
    }
    if (sum.count != 0) result.push_back(sum);
  }
}

}  // namespace

std::vector<LineEnd> find_line_ends(std::span<const CornerCount> corners, Carriers& carriers,
                                    VertexWelder& welder) {
  struct Planes {
    std::uint32_t carriers[3];
  };
  std::vector<Planes> planes(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (int k = 0; k < 3; ++k) planes[i].carriers[k] = carriers.carrier_of(corners[i].planes[k]);
  }
  std::vector<Vec3> points(corners.size());
  parallel_for(corners.size(), [&](std::size_t i) {
    const auto& p = planes[i].carriers;
    points[i] = intersection_point(carriers.plane(p[0]), carriers.plane(p[1]), carriers.plane(p[2]))
                    .position;
  });
  std::vector<std::uint32_t> vertices;
  welder.weld(points, vertices);

  // The corners again, vertex by vertex.
  std::vector<std::uint32_t> begin(welder.vertices().size() + 1);
  for (const std::uint32_t vertex : vertices) ++begin[vertex + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> sorted(corners.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t i = 0; i < corners.size(); ++i) sorted[next[vertices[i]]++] = i;

  constexpr std::uint32_t kVerticesPerTask = 4096;
  const auto vertex_count = static_cast<std::uint32_t>(welder.vertices().size());
  std::vector<std::vector<LineEnd>> parts((vertex_count + kVerticesPerTask - 1) / kVerticesPerTask);
  parallel_for(parts.size(), [&](std::size_t part) {
    std::vector<LineEnd> here;
    const auto first = static_cast<std::uint32_t>(part) * kVerticesPerTask;
    const std::uint32_t last = std::min(vertex_count, first + kVerticesPerTask);
    for (std::uint32_t vertex = first; vertex < last; ++vertex) {
      here.clear();
      for (std::uint32_t k = begin[vertex]; k < begin[vertex + 1]; ++k) {
        append_ends(corners[sorted[k]], planes[sorted[k]].carriers, vertex, here);
      }
      sum_up(here, parts[part]);
    }
  });
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  std::vector<LineEnd> result;
  result.reserve(count);
  for (const auto& part : parts) result.insert(result.end(), part.begin(), part.end());
  return result;
}

}  // namespace spoctree
