#include "server/build/cell_volume.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace spoctree {

namespace {

/// Is there material at the corner, seen from within the cell? Where the boundary passes through
/// the corner, it is asked a step along z away from it, a far smaller step along y, and a still
/// smaller one along x: away from what ends in the corner, then from what lies in the edge along z.
bool is_material_at(const Solid& solid, const SolidQueries& queries, const Cell& cell,
                    unsigned octant) {
  if (cell.corners[octant] != CornerState::Unknown &&
      cell.corners[octant] != CornerState::Boundary) {
    return cell.corners[octant] == CornerState::Inside;
  }
  const Vec3 corner = cell.corner_position(solid, octant);
  const Vec3 centre = 0.5 * (cell.corner_position(solid, 0) + cell.corner_position(solid, 7));
  const Vec3 within = corner + (centre - corner) * Vec3{0x1.1p-30, 0x1.3p-20, 0x1.7p-10};
  return queries.side_of(within) == SolidQueries::Side::In;
}

}  // namespace

double material_volume(const Solid& solid, const SolidQueries& queries, const Cell& cell) {
  const double side = cell.wall(solid, 0, true) - cell.wall(solid, 0, false);
  const auto known = std::find_if(cell.corners.begin(), cell.corners.end(), [](CornerState state) {
    return state == CornerState::Inside || state == CornerState::Outside;
  });
  const unsigned octant =
      known == cell.corners.end() ? 7 : static_cast<unsigned>(known - cell.corners.begin());
  // Coordinates from the opposite corner towards the chosen one, all 0 .. side. Mirroring an axis
  // turns the orientation of the boundary around.
  const Vec3 origin = cell.corner_position(solid, octant ^ 7u);
  const Vec3 mirror{(octant & 1) ? 1.0 : -1.0, (octant & 2) ? 1.0 : -1.0,
                    (octant & 4) ? 1.0 : -1.0};
  const double orientation = mirror.x * mirror.y * mirror.z;
  const Vec3 far = cell.corner_position(solid, octant);
  const auto on_far_wall = [&](const FragmentCorner& corner, int axis) {
    return ((corner.pinned >> axis) & 1) != 0 && corner.position[axis] == far[axis];
  };

  double volume = 0;
  double wall_area = 0;
  double edge_length = is_material_at(solid, queries, cell, octant) ? side : 0;
  for (const Fragment& fragment : cell.boundary.fragments) {
    const auto corners = cell.boundary.corners_of(fragment);
    const bool in_far_wall = std::all_of(
        corners.begin(), corners.end(), [&](const auto& corner) { return on_far_wall(corner, 0); });
    if (in_far_wall) continue;  // the flux through the far wall is counted by its area
    const Vec3 a = (corners[0].position - origin) * mirror;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const FragmentCorner& from = corners[i];
      const FragmentCorner& to = corners[i + 1 == corners.size() ? 0 : i + 1];
      const Vec3 u = (from.position - origin) * mirror;
      const Vec3 v = (to.position - origin) * mirror;
      // Projected on the plane x = 0, the triangle (a, u, v) has this area; times its mean height.
      const double projected =
          0.5 * ((u.y - a.y) * (v.z - a.z) - (u.z - a.z) * (v.y - a.y)) * orientation;
      volume += projected * (a.x + u.x + v.x) / 3;
      if (!on_far_wall(from, 0) || !on_far_wall(to, 0)) continue;
      // An edge in the far wall: the wall's material has it on its rim, the other way round. Again,
      // what lies in the far edge is counted by the length of material beside that, and what ends
      // in the corner by the material beside the corner.
      if (on_far_wall(from, 1) && on_far_wall(to, 1)) continue;
      wall_area -= 0.5 * (u.y + v.y) * (v.z - u.z) * orientation;
      if (on_far_wall(from, 1) && !on_far_wall(from, 2)) edge_length -= u.z * orientation;
      if (on_far_wall(to, 1) && !on_far_wall(to, 2)) edge_length += v.z * orientation;
    }
  }
  return volume + side * (wall_area + side * edge_length);
}

double boundary_area(const Cell& cell) {
  double area = 0;
  for (const Fragment& fragment : cell.boundary.fragments) {
    const auto corners = cell.boundary.corners_of(fragment);
    Vec3 doubled{0.0};
    for (std::size_t i = 2; i < corners.size(); ++i) {
      doubled += glm::cross(corners[i - 1].position - corners[0].position,
                            corners[i].position - corners[0].position);
    }
    area += 0.5 * glm::length(doubled);
  }
  return area;
}

}  // namespace spoctree
