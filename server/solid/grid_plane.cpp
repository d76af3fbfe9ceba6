#include "server/solid/grid_plane.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <limits>

namespace spoctree {

namespace {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    512, 512, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;

// Bound on the error of `approximate` below, in steps of the grid. Components of unit normals carry
// some six roundings of values up to 2^52, offsets are sums of three products with such.
static_assert(std::numeric_limits<long double>::digits >= 64);
constexpr long double kErrorBound = 0x1p52L * 32 * std::numeric_limits<long double>::epsilon();

Wide squared_length(const AreaVector& v) {
  return Wide(v[0]) * v[0] + Wide(v[1]) * v[1] + Wide(v[2]) * v[2];
}

// numerator / sqrt(squared_denominator), rounded to the nearest integer. `approximate` is off by
// at most kErrorBound; integers decide only where that leaves a choice.
template <class ExactNumerator>
std::int64_t round_quotient(long double approximate, ExactNumerator numerator,
                            const AreaVector& area) {
  const long double magnitude = std::fabs(approximate);
  const long double floor = std::floor(magnitude);
  const long double past_half = magnitude - floor - 0.5L;
  auto rounded = static_cast<std::int64_t>(floor);
  if (past_half > kErrorBound) {
    ++rounded;
  } else if (past_half >= -kErrorBound) {
    const Wide twice = 2 * Wide(numerator());
    const Wide limit = 2 * Wide(rounded) + 1;
    if (twice * twice > limit * limit * squared_length(area)) ++rounded;
  }
  return approximate < 0 ? -rounded : rounded;
}

}  // namespace

GridPlane nearest_plane(const AreaVector& area, const GridPoint& point) {
  const long double x[3] = {static_cast<long double>(area[0]), static_cast<long double>(area[1]),
                            static_cast<long double>(area[2])};
  const long double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  GridPlane plane;
  long double scalar_product = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Int128 component = area[i];
    plane.normal[i] = round_quotient(
        x[i] / length * 0x1p52L, [component] { return Wide(component) << kGridBits; }, area);
    scalar_product += x[i] / length * static_cast<long double>(point[i]);
  }
  plane.offset = round_quotient(
      scalar_product,
      [&] {
        return Wide(area[0]) * point[0] + Wide(area[1]) * point[1] + Wide(area[2]) * point[2];
      },
      area);
  return plane;
}

GridPoint round_direction(long double x, long double y, long double z) {
  const long double length = std::sqrt(x * x + y * y + z * z);
  return {std::llrint(x / length * 0x1p52L), std::llrint(y / length * 0x1p52L),
          std::llrint(z / length * 0x1p52L)};
}

}  // namespace spoctree
