// Planes of triangles and their rounding to the grid.
#pragma once

#include <compare>

#include "common/geometry/plane.hpp"
#include "server/solid/grid_integers.hpp"

namespace spoctree {

/// A plane as its four integers, in units of 2^-52.
struct GridPlane {
  GridPoint normal{};
  std::int64_t offset = 0;

  /// Height of a grid point above the plane through the origin, in units of 2^-104.
  Int128 height(const GridPoint& p) const { return dot(normal, p); }
  Plane to_plane() const {
    return {{static_cast<double>(normal[0]) * 0x1p-52, static_cast<double>(normal[1]) * 0x1p-52,
             static_cast<double>(normal[2]) * 0x1p-52},
            static_cast<double>(offset) * 0x1p-52};
  }
  auto operator<=>(const GridPlane&) const = default;
};

/// A corner within this of a plane counts as on it: it is what rounding planes and corners to the
/// grid makes of one that is. Universe units.
inline constexpr long double kGridFlatness = 0x1p-49L;

/// True if the point is within kGridFlatness of the plane. Exact.
inline bool is_on(const GridPlane& plane, const GridPoint& point) {
  constexpr Int128 kMost = Int128{1} << (2 * kGridBits - 49);
  static_assert(kGridFlatness == 0x1p-49L);
  const Int128 height = plane.height(point) - (static_cast<Int128>(plane.offset) << kGridBits);
  return -kMost <= height && height <= kMost;
}

/// The grid plane nearest to the plane through `point` with the direction of `area`: each of the
/// four numbers is the correctly rounded value of the exact one. So triangles in exactly one plane
/// get equal planes, whichever their shapes and sizes.
/// REQUIRES: `area` is an area vector, not zero; `point` is in the universe cube.
GridPlane nearest_plane(const AreaVector& area, const GridPoint& point);

/// The unit vector of a direction, each component rounded to the grid to within one step.
/// REQUIRES: finite and not zero.
GridPoint round_direction(long double x, long double y, long double z);

/// The smallest offset that has all points of height `largest_height` or less in the half-space.
inline std::int64_t offset_above(Int128 largest_height) {
  return static_cast<std::int64_t>((largest_height + ((Int128{1} << kGridBits) - 1)) >> kGridBits);
}

}  // namespace spoctree
