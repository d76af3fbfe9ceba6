// Coordinates of the grid as integers, in units of 2^-52: where "exactly" means exactly.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "common/geometry/universe.hpp"

namespace spoctree {

__extension__ using Int128 = __int128;
using GridPoint = std::array<std::int64_t, 3>;

/// REQUIRES: a multiple of 2^-52 of at most 2^10 in magnitude.
inline std::int64_t to_grid_integer(double value) {
  return static_cast<std::int64_t>(value * 0x1p52);
}
inline GridPoint to_grid_integers(Vec3 v) {
  return {to_grid_integer(v.x), to_grid_integer(v.y), to_grid_integer(v.z)};
}

/// The scalar product, in units of 2^-104; below 2^108 for normals and points of the universe cube.
inline Int128 dot(const GridPoint& p, const GridPoint& q) {
  return static_cast<Int128>(p[0]) * q[0] + static_cast<Int128>(p[1]) * q[1] +
         static_cast<Int128>(p[2]) * q[2];
}

/// The cross product of two edges of a triangle: its normal, of the length of twice its area, in
/// units of 2^-104. Components are below 2^108.
using AreaVector = std::array<Int128, 3>;
inline AreaVector area_vector(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  const GridPoint u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const GridPoint v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const auto minor = [&](int i, int j) {
    return static_cast<Int128>(u[i]) * v[j] - static_cast<Int128>(u[j]) * v[i];
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

}  // namespace spoctree
