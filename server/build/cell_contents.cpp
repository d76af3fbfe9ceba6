#include "server/build/cell_contents.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace spoctree {

bool is_all_material(const Solid& solid, const SolidQueries& queries, const Cell& cell) {
  if (!cell.boundary.fragments.empty()) return true;
  const auto known = std::find_if(cell.corners.begin(), cell.corners.end(), [](CornerState s) {
    return s == CornerState::Inside || s == CornerState::Outside;
  });
  if (known != cell.corners.end()) return *known == CornerState::Inside;
  return queries.side_of(cell.centre(solid)) == SolidQueries::Side::In;
}

std::uint32_t triangle_near_centre(const Solid& solid, const Cell& cell,
                                   std::span<const Fragment> fragments) {
  const Vec3 centre = cell.centre(solid);
  double nearest = std::numeric_limits<double>::infinity();
  std::uint32_t triangle = 0;
  for (const Fragment& fragment : fragments) {
    Vec3 sum{0.0};
    for (const FragmentCorner& corner : cell.boundary.corners_of(fragment)) sum += corner.position;
    const Vec3 offset = sum / static_cast<double>(fragment.corner_count) - centre;
    const double distance = glm::dot(offset, offset);
    if (distance < nearest) {
      nearest = distance;
      triangle = fragment.triangle;
    }
  }
  return triangle;
}

}  // namespace spoctree
