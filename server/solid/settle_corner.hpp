// One corner and the planes it is to lie on -> where it goes, and which planes it cannot reach.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "server/solid/grid_plane.hpp"

namespace spoctree {

/// A plane, seen from a corner. Lengths in universe units.
struct CornerPlane {
  std::array<long double, 3> normal;
  long double height = 0;  ///< of the plane above the corner
  bool is_reached = false;
};

/// The shortest way from the corner to a point that lies on all planes it reaches. Planes are tried
/// in order; one is reached if the point that lies on it and on those before it (at most three that
/// are not nearly parallel; others have to pass within kGridFlatness) is nearer than `most_move`.
/// Sets is_reached. Linear.
std::array<long double, 3> settle_corner(std::span<CornerPlane> planes, long double most_move);

}  // namespace spoctree
