// The solid's triangles clipped to cells, with corners that remember how they arose.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "server/build/incidence.hpp"
#include "server/solid/solid.hpp"

namespace spoctree {

/// A corner of a clipped triangle. `position` is exact on the axes in `pinned` (there it is the
/// coordinate of a wall of the cell) and everywhere if it is a vertex; elsewhere it errs by at most
/// `error`.
struct FragmentCorner {
  enum class Origin : std::uint8_t {
    Vertex,  ///< vertex `a` of the solid
    Edge,    ///< the edge from vertex a to b meets the wall on `axis`
    Face     ///< the plane of the triangle meets the walls on `axis` and `second_axis`
  };
  Vec3 position{0.0};
  double error = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  Origin origin = Origin::Vertex;
  std::uint8_t axis = 0;
  std::uint8_t second_axis = 0;
  std::uint8_t pinned = 0;  ///< bit per axis: lies exactly on a wall across that axis
  /// The polygon edge that leaves this corner: 0..2 an edge of the triangle, 3 + axis a wall.
  std::uint8_t edge = 0;
};

/// The part of one triangle in one closed cell: a convex polygon with area.
struct Fragment {
  std::uint32_t triangle = 0;
  std::uint32_t first_corner = 0;
  std::uint32_t corner_count = 0;
};

/// The boundary of the solid in one cell.
struct FragmentList {
  std::vector<Fragment> fragments;
  std::vector<FragmentCorner> corners;

  std::span<const FragmentCorner> corners_of(const Fragment& fragment) const {
    return {corners.data() + fragment.first_corner, fragment.corner_count};
  }
  void clear() {
    fragments.clear();
    corners.clear();
  }
};

/// All triangles, unclipped: the list of the root cell.
FragmentList whole_boundary(const Solid& solid);

/// Exact questions about corners.
class CornerSides {
 public:
  CornerSides(const Solid& solid, const Incidence& incidence)
      : solid_(&solid), incidence_(&incidence), doubt_(0x1p-46 + solid.largest_incidence_gap) {}

  /// Side of a corner with respect to plane `plane` of the solid: 0 where incidence says so, the
  /// exact sign elsewhere. `triangle` is the one the corner belongs to.
  int side(const FragmentCorner& corner, std::uint32_t triangle, std::uint32_t plane) const {
    const Plane& p = solid_->planes[plane];
    const double value = glm::dot(p.normal, corner.position) - p.offset;
    if (std::abs(value) > doubt_ + 2 * corner.error) return value > 0 ? 1 : -1;
    return side_in_doubt(corner, triangle, plane);
  }
  /// Side of a corner with respect to the wall { y[axis] = coordinate }.
  int side_of_wall(const FragmentCorner& corner, std::uint32_t triangle, int axis,
                   double coordinate) const {
    const double value = corner.position[axis] - coordinate;
    if (std::abs(value) > corner.error) return value > 0 ? 1 : -1;
    return side_of_wall_in_doubt(corner, triangle, axis, coordinate);
  }
  /// Distances beyond this (plus the corner's error) are not in doubt.
  double doubt() const { return doubt_; }

 private:
  int side_in_doubt(const FragmentCorner& corner, std::uint32_t triangle,
                    std::uint32_t plane) const;
  int side_of_wall_in_doubt(const FragmentCorner& corner, std::uint32_t triangle, int axis,
                            double coordinate) const;
  int exact_side(const FragmentCorner& corner, std::uint32_t triangle, const Plane& plane) const;

  const Solid* solid_;
  const Incidence* incidence_;
  double doubt_;
};

/// Splits `fragments`, which are of `list`, by the wall { y[axis] = coordinate } and appends the
/// parts that have area to `lower` and `upper`. A triangle in the wall goes to the side of its
/// material.
void split_fragments(const FragmentList& list, std::span<const Fragment> fragments,
                     const Solid& solid, const CornerSides& sides, int axis, double coordinate,
                     FragmentList& lower, FragmentList& upper);

}  // namespace spoctree
