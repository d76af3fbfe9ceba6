// The universe cube of a solid and the coordinates in which all exact work is done.
//
// Universe coordinates: y = (x - center) * 2^-scale_exponent, rounded to multiples of 2^-52 (the
// grid), with |y| <= half_side <= 1 on every axis inside the cube. The scaling is exact; the
// translation is exact for all but the last bits of some doubles, so a vertex moves by at most
// 2^-53 of the frame. From there on nothing is rounded: grid points, cell walls and planes are
// integers of at most 54 bits, stored in doubles.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

namespace spoctree {

using Vec3 = glm::dvec3;

/// Nodes lie at depth 0 (the root) to kMaxDepth. At this depth the walls still lie on the grid.
inline constexpr int kMaxDepth = 30;

/// One step of the grid is 2^-kGridBits.
inline constexpr int kGridBits = 52;

/// half_side is a multiple of 2^-kHalfSideBits, so that walls of every depth are on the grid.
inline constexpr int kHalfSideBits = 20;

/// The universe cube: the axis-aligned cube with centre `center` (model coordinates) and half side
/// `half_side * 2^scale_exponent` (model units).
struct Universe {
  Vec3 center{0.0};
  int scale_exponent = 0;
  double half_side = 1.0;  ///< in universe coordinates: in (0.5, 1], a multiple of 2^-20

  /// Model length of one unit of universe coordinates.
  double scale() const { return std::ldexp(1.0, scale_exponent); }
  /// Side and diagonal of the cube in model units.
  double side() const { return 2 * half_side * scale(); }
  double diagonal() const { return std::sqrt(3.0) * side(); }

  Vec3 to_model(Vec3 y) const { return center + y * scale(); }
  /// The universe coordinates of a model point, rounded to the nearest grid point.
  Vec3 to_grid(Vec3 x) const;
  /// The universe coordinates of a model point, rounded as doubles are (finer than the grid near
  /// 0).
  Vec3 to_universe(Vec3 x) const { return (x - center) / scale(); }

  bool operator==(const Universe&) const = default;
};

/// The universe cube of a bounding box: the smallest cube around it, larger by a hair (0.2 % to
/// 0.5 % of the side) and off centre by less than that hair, so that symmetric solids do not have
/// their faces and edges exactly in cell walls (that would be correct, but costs nodes).
/// Where coordinates are so far from the origin that no double lies within a hair of the box's
/// middle, the cube is as much larger as it takes to contain the box.
/// Throws BadInput if the box's largest side is not between 2^-900 and 2^900 (0, for example).
/// REQUIRES: finite, lower <= upper.
Universe universe_around(Vec3 lower, Vec3 upper);

/// How much model coordinates in the cube are rounded, in universe units: 2^-52 for cubes around
/// the origin, more for those far from it, which doubles cannot tell apart any finer; 2^-43 at
/// most.
double coordinate_rounding(const Universe& universe);

/// True for the values that `Universe` promises; decoders ask before they trust one.
bool is_valid(const Universe& universe);

/// The coordinate of wall `index` (0 .. 2^kMaxDepth) in universe coordinates: exact.
inline double wall_coordinate(double half_side, std::uint32_t index) {
  static_assert(kMaxDepth == 30);
  return half_side * (static_cast<double>(index) * 0x1p-29 - 1.0);
}

}  // namespace spoctree
