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

/// Appends the parts of a polygon below and above a wall that it meets. `side` is that of each of
/// its corners.
void split_polygon(std::span<const FragmentCorner> polygon, const std::vector<signed char>& side,
                   std::uint32_t triangle, const Solid& solid, int axis, double coordinate,
                   FragmentList* lower, FragmentList* upper) {
  const auto wall = static_cast<std::uint8_t>(3 + axis);
  const auto begin = [triangle](FragmentList* list) {
    if (list == nullptr) return;
    list->fragments.push_back({triangle, static_cast<std::uint32_t>(list->corners.size()), 0});
  };
  const auto end = [](FragmentList* list) {
    if (list == nullptr) return;
    Fragment& part = list->fragments.back();
    part.corner_count = static_cast<std::uint32_t>(list->corners.size()) - part.first_corner;
  };
  const auto add = [](FragmentList* list, const FragmentCorner& corner, std::uint8_t edge) {
    if (list == nullptr) return;
    list->corners.push_back(corner);
    list->corners.back().edge = edge;
  };
  begin(lower);
  begin(upper);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = i + 1 == polygon.size() ? 0 : i + 1;
    const int here = side[i];
    const int there = side[j];
    const FragmentCorner& corner = polygon[i];
    if (here < 0) add(lower, corner, corner.edge);
    if (here > 0) add(upper, corner, corner.edge);
    if (here == 0) {
      FragmentCorner on_wall = corner;
      on_wall.pinned = static_cast<std::uint8_t>(corner.pinned | (1u << axis));
      on_wall.position[axis] = coordinate;
      add(lower, on_wall, there > 0 ? wall : corner.edge);
      add(upper, on_wall, there < 0 ? wall : corner.edge);
    }
    if (here * there < 0) {
      const FragmentCorner crossing =
          cross_wall(corner, polygon[j], triangle, solid, axis, coordinate);
      add(lower, crossing, here < 0 ? wall : corner.edge);
      add(upper, crossing, here > 0 ? wall : corner.edge);
    }
  }
  end(lower);
  end(upper);
}

/// Appends a polygon as it is.
void copy_polygon(std::span<const FragmentCorner> polygon, std::uint32_t triangle,
                  FragmentList& to) {
  to.fragments.push_back({triangle, static_cast<std::uint32_t>(to.corners.size()),
                          static_cast<std::uint32_t>(polygon.size())});
  to.corners.insert(to.corners.end(), polygon.begin(), polygon.end());
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

int CornerSides::side_in_doubt(const FragmentCorner& corner, std::uint32_t triangle,
                               std::uint32_t plane) const {
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
  return exact_side(corner, triangle, solid_->planes[plane]);
}

int CornerSides::side_of_wall_in_doubt(const FragmentCorner& corner, std::uint32_t triangle,
                                       int axis, double coordinate) const {
  const double value = corner.position[axis] - coordinate;
  const bool exact =
      corner.origin == FragmentCorner::Origin::Vertex || ((corner.pinned >> axis) & 1) != 0;
  if (exact) return value > 0 ? 1 : (value < 0 ? -1 : 0);
  return exact_side(corner, triangle, wall_plane(axis, coordinate));
}

void split_fragments(const FragmentList& list, std::span<const Fragment> fragments,
                     const Solid& solid, const CornerSides& sides, int axis, double coordinate,
                     FragmentList& lower, FragmentList& upper) {
  std::vector<signed char> side;  // of nine corners at most, but where rounding left a polygon
                                  // slightly non-convex
  for (const Fragment& fragment : fragments) {
    const auto polygon = list.corners_of(fragment);
    side.resize(polygon.size());
    bool any_lower = false;
    bool any_on = false;
    bool any_upper = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const int s = sides.side_of_wall(polygon[i], fragment.triangle, axis, coordinate);
      side[i] = static_cast<signed char>(s);
      any_lower |= s < 0;
      any_on |= s == 0;
      any_upper |= s > 0;
    }
    if (!any_lower && !any_upper) {
      // In the wall: its material is on the side the normal points away from.
      const bool material_below = plane_of(solid, fragment.triangle).normal[axis] > 0;
      any_lower = material_below;
      any_upper = !material_below;
    }
    if (any_on || any_lower == any_upper) {
      split_polygon(polygon, side, fragment.triangle, solid, axis, coordinate,
                    any_lower ? &lower : nullptr, any_upper ? &upper : nullptr);
    } else {
      copy_polygon(polygon, fragment.triangle, any_lower ? lower : upper);
    }
  }
}

}  // namespace spoctree
