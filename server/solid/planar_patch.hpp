// Triangles that are flat within a tolerance, while their plane is still being looked for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "server/solid/grid_plane.hpp"

namespace spoctree {

/// The heights of some points above a plane through the origin, in units of 2^-104.
struct HeightRange {
  Int128 lowest = Int128{1} << 120;
  Int128 highest = -(Int128{1} << 120);

  void add(Int128 height) {
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  void add(const HeightRange& other) {
    lowest = std::min(lowest, other.lowest);
    highest = std::max(highest, other.highest);
  }
  Int128 spread() const { return highest - lowest; }
};

/// Triangles that lie near one plane.
struct PlanarPatch {
  GridPlane plane;       ///< of the first triangle, or with the mean normal
  HeightRange range;     ///< of all corners above `plane`
  bool is_exact = true;  ///< the planes of all triangles are equal to `plane`
  double area = 0;       ///< universe units; of its projection on its plane
  std::vector<std::uint32_t> triangles;
};

/// A length in universe units as a difference of heights.
inline Int128 to_height(double length) {
  return static_cast<Int128>(std::ldexp(length, 2 * kGridBits));
}

}  // namespace spoctree
