#include "server/build/fragment.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "common/geometry/predicates.hpp"

namespace spoctree {

namespace {

Plane wall_plane(int axis, double coordinate) {
  Plane plane;
  plane.normal[axis] = 1.0;
  plane.offset = coordinate;
  return plane;
}

Plane wall_through(const FragmentCorner& corner, int axis) {
  return wall_plane(axis, corner.position[axis]);
}

const Plane& plane_of(const Solid& solid, std::uint32_t triangle) {
  return solid.planes[solid.facet_plane[solid.triangles[triangle].facet]];
}

/// The corner in which the polygon edge from `from` to `to` meets the wall.
FragmentCorner cross_wall(const FragmentCorner& from, const FragmentCorner& to,
                          std::uint32_t triangle, const Solid& solid, int axis, double coordinate) {
  FragmentCorner corner;
  corner.axis = static_cast<std::uint8_t>(axis);
  // The new corner lies on the walls that hold both ends.
  corner.pinned = static_cast<std::uint8_t>(1u << axis);
  for (int k = 0; k < 3; ++k) {
    const bool both_pinned = ((from.pinned & to.pinned) >> k) & 1;
    if (both_pinned && from.position[k] == to.position[k]) {
      corner.pinned = static_cast<std::uint8_t>(corner.pinned | (1u << k));
    }
  }
  if (from.edge < 3) {
    const SolidTriangle& t = solid.triangles[triangle];
    const std::uint32_t u = t.vertex[from.edge];
    const std::uint32_t v = t.vertex[(from.edge + 1) % 3];
    corner.origin = FragmentCorner::Origin::Edge;
    corner.a = std::min(u, v);
    corner.b = std::max(u, v);
    const Vec3 a = solid.vertices[corner.a];
    const Vec3 b = solid.vertices[corner.b];
    corner.position = a + (b - a) * ((coordinate - a[axis]) / (b[axis] - a[axis]));
    corner.error = 0x1p-49;  // |b - a| <= 2 per axis, t and the product off by a few roundings
  } else {
    corner.origin = FragmentCorner::Origin::Face;
    corner.second_axis = static_cast<std::uint8_t>(from.edge - 3);
    const ApproximatePoint point =
        intersection_point(plane_of(solid, triangle), wall_plane(axis, coordinate),
                           wall_through(from, corner.second_axis));
    corner.position = point.position;
    corner.error = point.error;
  }
  for (int k = 0; k < 3; ++k) {
    if (k != axis && ((corner.pinned >> k) & 1)) corner.position[k] = from.position[k];
  }
  corner.position[axis] = coordinate;
  return corner;
}

/// The half of a polygon on the side of `keep` (-1 or +1), appended to `out` if it has area.
void clip_half(std::span<const FragmentCorner> polygon, const std::vector<int>& side, int keep,
               const Fragment& fragment, const Solid& solid, int axis, double coordinate,
               FragmentList& out) {
  Fragment part{fragment.triangle, static_cast<std::uint32_t>(out.corners.size()), 0};
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = i + 1 == count ? 0 : i + 1;
    const int here = side[i] * keep;
    const int there = side[j] * keep;
    if (here >= 0) {
      out.corners.push_back(polygon[i]);
      FragmentCorner& added = out.corners.back();
      if (here == 0) {
        added.pinned = static_cast<std::uint8_t>(added.pinned | (1u << axis));
        added.position[axis] = coordinate;
        if (there < 0) added.edge = static_cast<std::uint8_t>(3 + axis);
      }
    }
    if (here * there < 0) {
      FragmentCorner added =
          cross_wall(polygon[i], polygon[j], fragment.triangle, solid, axis, coordinate);
      added.edge = here > 0 ? static_cast<std::uint8_t>(3 + axis) : polygon[i].edge;
      out.corners.push_back(added);
    }
  }
  part.corner_count = static_cast<std::uint32_t>(out.corners.size()) - part.first_corner;
  out.fragments.push_back(part);
}

}  // namespace

FragmentList whole_boundary(const Solid& solid) {
  FragmentList list;
  list.fragments.reserve(solid.triangles.size());
  list.corners.reserve(3 * solid.triangles.size());
  for (std::uint32_t t = 0; t < solid.triangles.size(); ++t) {
    list.fragments.push_back({t, static_cast<std::uint32_t>(list.corners.size()), 3});
    for (std::uint8_t k = 0; k < 3; ++k) {
      FragmentCorner corner;
      corner.a = solid.triangles[t].vertex[k];
      corner.position = solid.vertices[corner.a];
      corner.edge = k;
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(corner.position[axis]) == solid.universe.half_side) {
          corner.pinned = static_cast<std::uint8_t>(corner.pinned | (1u << axis));
        }
      }
      list.corners.push_back(corner);
    }
  }
  return list;
}

int CornerSides::exact_side(const FragmentCorner& corner, std::uint32_t triangle,
                            const Plane& plane) const {
  switch (corner.origin) {
    case FragmentCorner::Origin::Vertex:
      return side_of_point(plane, solid_->vertices[corner.a]);
    case FragmentCorner::Origin::Edge:
      return side_of_crossing(solid_->vertices[corner.a], solid_->vertices[corner.b],
                              wall_through(corner, corner.axis), plane);
    case FragmentCorner::Origin::Face:
      return side_of_intersection(plane_of(*solid_, triangle), wall_through(corner, corner.axis),
                                  wall_through(corner, corner.second_axis), plane);
  }
  return 0;
}

int CornerSides::side(const FragmentCorner& corner, std::uint32_t triangle,
                      std::uint32_t plane) const {
  const Plane& p = solid_->planes[plane];
  const double value = glm::dot(p.normal, corner.position) - p.offset;
  if (std::abs(value) > doubt_ + 2 * corner.error) return value > 0 ? 1 : -1;
  switch (corner.origin) {
    case FragmentCorner::Origin::Vertex:
      if (incidence_->is_on(corner.a, plane)) return 0;
      break;
    case FragmentCorner::Origin::Edge:
      if (incidence_->is_on(corner.a, plane) && incidence_->is_on(corner.b, plane)) return 0;
      break;
    case FragmentCorner::Origin::Face:
      if (solid_->facet_plane[solid_->triangles[triangle].facet] == plane) return 0;
      break;
  }
  return exact_side(corner, triangle, p);
}

int CornerSides::side_of_wall(const FragmentCorner& corner, std::uint32_t triangle, int axis,
                              double coordinate) const {
  const double value = corner.position[axis] - coordinate;
  const bool exact =
      corner.origin == FragmentCorner::Origin::Vertex || ((corner.pinned >> axis) & 1) != 0;
  if (exact || std::abs(value) > corner.error) return value > 0 ? 1 : (value < 0 ? -1 : 0);
  return exact_side(corner, triangle, wall_plane(axis, coordinate));
}

void split_fragments(const FragmentList& list, std::span<const Fragment> fragments,
                     const Solid& solid, const CornerSides& sides, int axis, double coordinate,
                     FragmentList& lower, FragmentList& upper) {
  std::vector<int> side;  // nine at most, but for polygons that rounding left slightly non-convex
  for (const Fragment& fragment : fragments) {
    const auto polygon = list.corners_of(fragment);
    side.resize(polygon.size());
    bool any_lower = false;
    bool any_upper = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      side[i] = sides.side_of_wall(polygon[i], fragment.triangle, axis, coordinate);
      any_lower |= side[i] < 0;
      any_upper |= side[i] > 0;
    }
    if (!any_lower && !any_upper) {
      // In the wall: its material is on the side the normal points away from.
      const bool material_below = plane_of(solid, fragment.triangle).normal[axis] > 0;
      any_lower = material_below;
      any_upper = !material_below;
    }
    if (any_lower) clip_half(polygon, side, -1, fragment, solid, axis, coordinate, lower);
    if (any_upper) clip_half(polygon, side, +1, fragment, solid, axis, coordinate, upper);
  }
}

}  // namespace spoctree
