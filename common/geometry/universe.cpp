#include "common/geometry/universe.hpp"

#include <algorithm>

namespace spoctree {

namespace {

double round_to_grid(double value, int bits) {
  return std::ldexp(std::nearbyint(std::ldexp(value, bits)), -bits);
}

}  // namespace

Vec3 Universe::to_grid(Vec3 x) const {
  const Vec3 y = to_universe(x);
  return {round_to_grid(y.x, kGridBits), round_to_grid(y.y, kGridBits),
          round_to_grid(y.z, kGridBits)};
}

Universe universe_around(Vec3 lower, Vec3 upper) {
  const Vec3 size = upper - lower;
  const double largest = std::max({size.x, size.y, size.z});
  // The smallest power of two that is at least the hair-enlarged half side.
  constexpr double kHair = 1.0 / 256;
  const double wanted_half_side = 0.5 * largest * (1 + kHair);
  int exponent = 0;
  const double mantissa = std::frexp(wanted_half_side, &exponent);  // in [0.5, 1)
  Universe universe;
  universe.scale_exponent = exponent;
  universe.half_side = std::ldexp(std::ceil(std::ldexp(mantissa, kHalfSideBits)), -kHalfSideBits);
  // Off centre by odd fractions of the hair; on a coarse grid, so that the translation of
  // single-precision coordinates is exact.
  const double step = std::ldexp(1.0, exponent - 24);
  const Vec3 shift = Vec3{3, 5, 7} * (kHair / 32) * wanted_half_side;
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = lower[axis] + 0.5 * size[axis];
    universe.center[axis] = std::nearbyint((middle + shift[axis]) / step) * step;
  }
  return universe;
}

bool is_valid(const Universe& universe) {
  const double scaled = std::ldexp(universe.half_side, kHalfSideBits);
  return std::isfinite(universe.center.x) && std::isfinite(universe.center.y) &&
         std::isfinite(universe.center.z) && universe.scale_exponent >= -1000 &&
         universe.scale_exponent <= 1000 && universe.half_side > 0.5 && universe.half_side <= 1.0 &&
         scaled == std::nearbyint(scaled);
}

}  // namespace spoctree
