#include "server/mesh/merge_equal_points.hpp"

#include <utility>

#include "server/mesh/point_table.hpp"

namespace spoctree {

void merge_equal_points(PolygonSoup& soup) {
  std::vector<bool> is_used(soup.points.size(), false);
  for (const std::uint32_t corner : soup.corners) is_used[corner] = true;

  std::vector<glm::dvec3> merged;
  merged.reserve(soup.points.size());
  PointTable table(merged);
  std::vector<std::uint32_t> new_number(soup.points.size(), 0);
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    if (is_used[i]) new_number[i] = table.find_or_add(soup.points[i]);
  }
  for (std::uint32_t& corner : soup.corners) corner = new_number[corner];
  soup.points = std::move(merged);
  // What a dropped face had for itself is now unused; a second time nothing can collapse.
  if (drop_collapsed_faces(soup)) merge_equal_points(soup);
}

}  // namespace spoctree
