#include "tests/unit/build/cells.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace spoctree {

std::vector<Cell> cells_of(const Solid& solid, const Incidence& incidence, std::uint32_t depth) {
  const CornerSides sides(solid, incidence);
  const std::uint32_t count = 1u << depth;
  const std::uint32_t size = 1u << (kMaxDepth - static_cast<int>(depth));
  // Slices of the last axis cut, from the lowest up: each is cut off what is left.
  const auto slices = [&](FragmentList whole, int axis) {
    std::vector<FragmentList> parts;
    for (std::uint32_t i = 1; i < count; ++i) {
      FragmentList lower;
      FragmentList upper;
      split_fragments(whole, whole.fragments, solid, sides, axis,
                      wall_coordinate(solid.universe.half_side, i * size), lower, upper);
      parts.push_back(std::move(lower));
      whole = std::move(upper);
    }
    parts.push_back(std::move(whole));
    return parts;
  };
  std::vector<Cell> cells(std::size_t{count} * count * count);
  const auto by_x = slices(whole_boundary(solid), 0);
  for (std::uint32_t x = 0; x < count; ++x) {
    const auto by_y = slices(by_x[x], 1);
    for (std::uint32_t y = 0; y < count; ++y) {
      auto by_z = slices(by_y[y], 2);
      for (std::uint32_t z = 0; z < count; ++z) {
        Cell& cell = cells[(z * count + y) * count + x];
        cell.depth = depth;
        cell.lower[0] = x * size;
        cell.lower[1] = y * size;
        cell.lower[2] = z * size;
        cell.boundary = std::move(by_z[z]);
        cell.corners.fill(CornerState::Unknown);
      }
    }
  }
  return cells;
}

RationalPoint exact_point(const FragmentCorner& corner, std::uint32_t triangle,
                          const Solid& solid) {
  const auto wall = [&](int axis) {
    Plane plane;
    plane.normal[axis] = 1;
    plane.offset = corner.position[axis];
    return plane;
  };
  switch (corner.origin) {
    case FragmentCorner::Origin::Vertex:
      return to_rational(solid.vertices[corner.a]);
    case FragmentCorner::Origin::Edge: {
      const RationalPoint a = to_rational(solid.vertices[corner.a]);
      const RationalPoint b = to_rational(solid.vertices[corner.b]);
      const Rational t = (Rational(corner.position[corner.axis]) - a[corner.axis]) /
                         (b[corner.axis] - a[corner.axis]);
      return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
    }
    case FragmentCorner::Origin::Face:
      return exact_intersection(solid.planes[solid.facet_plane[solid.triangles[triangle].facet]],
                                wall(corner.axis), wall(corner.second_axis))
          .value();
  }
  return {};
}

Solid uneven_solid(int cells, Random& random) {
  const HeightField field =
      random_height_field(cells, Vec3(-0.75), 1.5 / cells, -0.25, 0.125, 8, random);
  const Solid even = height_field_solid(field);
  std::vector<Vec3> points = even.vertices;
  for (Vec3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = std::ldexp(std::nearbyint(std::ldexp(p[axis] + random.between(0, 0.05), 52)), -52);
    }
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const SolidTriangle& t : even.triangles) {
    triangles.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
  }
  return hand_solid(std::move(points), triangles);
}

double area_of(std::span<const FragmentCorner> polygon) {
  Vec3 twice{0.0};
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    twice += glm::cross(polygon[k].position - polygon[0].position,
                        polygon[k + 1].position - polygon[0].position);
  }
  return 0.5 * glm::length(twice);
}

Vec3 just_inside(const Solid& solid, const Cell& cell, unsigned octant) {
  const Vec3 corner = cell.corner_position(solid, octant);
  const Vec3 opposite = cell.corner_position(solid, octant ^ 7u);
  return corner + (opposite - corner) * Vec3(0x1.3p-22, 0x1.5p-22, 0x1.9p-22);
}

}  // namespace spoctree
