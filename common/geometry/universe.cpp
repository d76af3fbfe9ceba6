#include "common/geometry/universe.hpp"

#include <algorithm>
#include <string>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {

// Well inside the scale exponents that is_valid allows.
constexpr double kSmallestHalfSize = 0x1p-901;
constexpr double kLargestHalfSize = 0x1p899;

double round_to_grid(double value, int bits) {
  return std::ldexp(std::nearbyint(std::ldexp(value, bits)), -bits);
}

}  // namespace

Vec3 Universe::to_grid(Vec3 x) const {
  Vec3 y = to_universe(x);
  for (int axis = 0; axis < 3; ++axis) {
    // From 1 on, doubles are on the grid; far beyond it, the scaling would overflow.
    if (std::abs(y[axis]) < 1) y[axis] = round_to_grid(y[axis], kGridBits);
  }
  return y;
}

Universe universe_around(Vec3 lower, Vec3 upper) {
  const Vec3 half_size = 0.5 * upper - 0.5 * lower;  // halved first: the whole may overflow
  const double largest = std::max({half_size.x, half_size.y, half_size.z});
  if (!(largest >= kSmallestHalfSize && largest <= kLargestHalfSize)) {
    throw BadInput("the solid is too " + std::string(largest < 1 ? "small" : "large") +
                   ": its size is not between 2^-900 and 2^900");
  }
  constexpr double kHair = 1.0 / 256;
  Universe universe;
  // The smallest power of two, and the smallest half side, that exceed the wanted half side.
  const auto grow_beyond = [&](double wanted_half_side) {
    const double mantissa = std::frexp(wanted_half_side, &universe.scale_exponent);  // in [0.5, 1)
    universe.half_side =
        std::ldexp(std::floor(std::ldexp(mantissa, kHalfSideBits)) + 1, -kHalfSideBits);
  };
  grow_beyond(largest * (1 + kHair));
  // Off centre by odd fractions of the hair; on a coarse grid, so that the translation of
  // single-precision coordinates is exact.
  const double step = std::ldexp(1.0, universe.scale_exponent - 24);
  const Vec3 shift = Vec3{3, 5, 7} * (kHair / 32) * largest;
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = lower[axis] + half_size[axis] + shift[axis];
    const double centre = middle - std::remainder(middle, step);
    universe.center[axis] = centre;
    reach = std::max({reach, upper[axis] - centre, centre - lower[axis]});
  }
  // Far from the origin doubles are so coarse that the centre may miss the middle by more than a
  // hair.
  if (reach * (1 + kHair / 4) > largest * (1 + kHair)) grow_beyond(reach * (1 + kHair / 4));
  return universe;
}

double coordinate_rounding(const Universe& universe) {
  const Vec3 c = universe.center;
  const double farthest = std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)});
  return std::clamp(0x1p-52 * std::ldexp(farthest, -universe.scale_exponent), 0x1p-52, 0x1p-43);
}

bool is_valid(const Universe& universe) {
  const double scaled = std::ldexp(universe.half_side, kHalfSideBits);
  return std::isfinite(universe.center.x) && std::isfinite(universe.center.y) &&
         std::isfinite(universe.center.z) && universe.scale_exponent >= -1000 &&
         universe.scale_exponent <= 1000 && universe.half_side > 0.5 && universe.half_side <= 1.0 &&
         scaled == std::nearbyint(scaled);
}

}  // namespace spoctree
