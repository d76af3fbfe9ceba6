#include "tests/support/exact.hpp"

#include <utility>

namespace spoctree {

Rational exact_value(const Plane& plane, const RationalPoint& point) {
  Rational value = -Rational(plane.offset);
  for (int i = 0; i < 3; ++i) {
    value += Rational(plane.normal[i]) * point[static_cast<std::size_t>(i)];
  }
  return value;
}

int exact_sign(const Rational& value) { return value.sign(); }

boost::multiprecision::cpp_int exact_floor(const Rational& value, int bits) {
  using boost::multiprecision::cpp_int;
  const Rational scaled = value * Rational(cpp_int(1) << bits);
  cpp_int quotient = numerator(scaled) / denominator(scaled);  // towards zero
  if (scaled < Rational(quotient)) --quotient;
  return quotient;
}

std::optional<RationalPoint> exact_intersection(const Plane& p, const Plane& q, const Plane& r) {
  std::array<std::array<Rational, 4>, 3> rows;
  const Plane* const planes[] = {&p, &q, &r};
  for (std::size_t k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) rows[k][static_cast<std::size_t>(i)] = planes[k]->normal[i];
    rows[k][3] = planes[k]->offset;
  }
  for (std::size_t column = 0; column < 3; ++column) {
    std::size_t pivot = column;
    while (pivot < 3 && rows[pivot][column].is_zero()) ++pivot;
    if (pivot == 3) return std::nullopt;
    std::swap(rows[column], rows[pivot]);
    for (std::size_t row = 0; row < 3; ++row) {
      if (row == column || rows[row][column].is_zero()) continue;
      const Rational factor = rows[row][column] / rows[column][column];
      for (std::size_t i = column; i < 4; ++i) rows[row][i] -= factor * rows[column][i];
    }
  }
  return RationalPoint{rows[0][3] / rows[0][0], rows[1][3] / rows[1][1], rows[2][3] / rows[2][2]};
}

Rational exact_distance(const RationalPoint& a, const RationalPoint& b) {
  Rational largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational difference = abs(Rational(a[i] - b[i]));
    if (difference > largest) largest = difference;
  }
  return largest;
}

}  // namespace spoctree
