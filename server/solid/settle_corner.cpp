#include "server/solid/settle_corner.hpp"

#include <cmath>

namespace spoctree {

namespace {

using Direction = std::array<long double, 3>;

// Planes at a smaller angle (its sine) than this that both hold already say nothing new: moving
// along their common line and tilting out of it by this loses less than kGridFlatness.
constexpr long double kNearlyParallel = 1e-7L;

long double dot(const Direction& p, const Direction& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

Direction add(const Direction& p, long double factor, const Direction& q) {
  return {p[0] + factor * q[0], p[1] + factor * q[1], p[2] + factor * q[2]};
}

}  // namespace

Direction settle_corner(std::span<CornerPlane> planes, long double most_move) {
  std::array<Direction, 3> fixed{};  // orthonormal: the directions in which the corner is fixed
  std::size_t rank = 0;
  Direction way = {0, 0, 0};
  for (CornerPlane& plane : planes) {
    plane.is_reached = false;
    const long double missing = plane.height - dot(plane.normal, way);
    const bool holds = std::abs(missing) <= kGridFlatness;
    Direction rest = plane.normal;
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t i = 0; i < rank; ++i) rest = add(rest, -dot(rest, fixed[i]), fixed[i]);
    }
    const long double sine = std::sqrt(dot(rest, rest));
    if (rank == 3 || sine < kNearlyParallel) {
      plane.is_reached = holds;
      continue;
    }
    const Direction next = add(way, missing / (sine * sine), rest);
    if (dot(next, next) >= most_move * most_move) {
      plane.is_reached = holds;
      continue;
    }
    plane.is_reached = true;
    way = next;
    fixed[rank++] = {rest[0] / sine, rest[1] / sine, rest[2] / sine};
  }
  // Those that held along the way without fixing anything may have been left since.
  for (CornerPlane& plane : planes) {
    if (std::abs(plane.height - dot(plane.normal, way)) > kGridFlatness) plane.is_reached = false;
  }
  return way;
}

}  // namespace spoctree
