#include "common/geometry/predicates.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cassert>
#include <glm/geometric.hpp>

namespace spoctree {

namespace {

__extension__ using Int128 = __int128;
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    320, 320, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;

struct GridPlane {
  std::int64_t n[3];
  std::int64_t d;
};

std::int64_t to_grid_integer(double value) {
  return static_cast<std::int64_t>(std::ldexp(value, kGridBits));
}

GridPlane to_grid(const Plane& plane) {
  return {{to_grid_integer(plane.normal.x), to_grid_integer(plane.normal.y),
           to_grid_integer(plane.normal.z)},
          to_grid_integer(plane.offset)};
}

template <class Number>
int sign(const Number& value) {
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

/// normal . point - offset, in units of 2^-104; below 2^108 for points of the universe cube.
Int128 evaluate(const GridPlane& plane, const std::int64_t (&point)[3]) {
  Int128 sum = -(static_cast<Int128>(plane.d) << kGridBits);
  for (int i = 0; i < 3; ++i) sum += static_cast<Int128>(plane.n[i]) * point[i];
  return sum;
}

/// Cross product of two normals, in units of 2^-104; each component below 2^106.
std::array<Int128, 3> cross(const GridPlane& p, const GridPlane& q) {
  const auto minor = [&](int i, int j) {
    return static_cast<Int128>(p.n[i]) * q.n[j] - static_cast<Int128>(p.n[j]) * q.n[i];
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

/// The intersection of three planes as x[i] / w: real coordinates, exact.
struct Homogeneous {
  Wide x[3];
  Wide w;
};

Homogeneous intersect(const GridPlane& p, const GridPlane& q, const GridPlane& r) {
  const auto qr = cross(q, r);
  const auto rp = cross(r, p);
  const auto pq = cross(p, q);
  Homogeneous point;
  for (int i = 0; i < 3; ++i) {
    point.w += Wide(qr[i]) * p.n[i];
    point.x[i] = Wide(qr[i]) * p.d + Wide(rp[i]) * q.d + Wide(pq[i]) * r.d;
  }
  if (point.w.sign() < 0) {
    point.w = -point.w;
    for (Wide& x : point.x) x = -x;
  }
  return point;
}

double ratio(const Wide& numerator, const Wide& denominator) {
  return numerator.convert_to<double>() / denominator.convert_to<double>();
}

/// floor(numerator * 2^bits / denominator); the denominator is positive.
std::int64_t rounded_ratio(const Wide& numerator, const Wide& denominator, int bits) {
  const Wide scaled = abs(numerator) << bits;
  Wide quotient;
  Wide remainder;
  divide_qr(scaled, denominator, quotient, remainder);
  auto value = quotient.convert_to<std::int64_t>();
  if (numerator.sign() < 0) {
    value = -value;
    if (!remainder.is_zero()) --value;
  }
  return value;
}

// normal . point - offset in doubles, for |normal| <= 1, |point| <= 2, |offset| <= 2: four
// products and three sums of magnitude below 8 err by at most 7 * 8 * 2^-53 < 2^-47.
constexpr double kSideError = 0x1p-47;

}  // namespace

int side_of_point(const Plane& plane, Vec3 point) {
  const double value = glm::dot(plane.normal, point) - plane.offset;
  if (std::abs(value) > kSideError && std::abs(point.x) <= 2 && std::abs(point.y) <= 2 &&
      std::abs(point.z) <= 2) {
    return sign(value);
  }
  const std::int64_t grid_point[3] = {to_grid_integer(point.x), to_grid_integer(point.y),
                                      to_grid_integer(point.z)};
  return sign(evaluate(to_grid(plane), grid_point));
}

int side_of_any_point(const Plane& plane, Vec3 point) {
  const double value = glm::dot(plane.normal, point) - plane.offset;
  const double size = std::abs(point.x) + std::abs(point.y) + std::abs(point.z) + 2;
  if (std::abs(value) > size * 0x1p-48) return sign(value);
  const auto on_grid = [](double x) {
    const double scaled = x * 0x1p52;
    return std::abs(x) <= 2 && scaled == std::nearbyint(scaled);
  };
  if (on_grid(point.x) && on_grid(point.y) && on_grid(point.z)) return side_of_point(plane, point);
  using Rational = boost::multiprecision::cpp_rational;
  Rational sum = -Rational(plane.offset);
  for (int i = 0; i < 3; ++i) sum += Rational(plane.normal[i]) * Rational(point[i]);
  return sign(sum);
}

int side_of_intersection(const Plane& p, const Plane& q, const Plane& r, const Plane& plane) {
  const Homogeneous point = intersect(to_grid(p), to_grid(q), to_grid(r));
  assert(point.w.sign() > 0);
  const GridPlane g = to_grid(plane);
  Wide value = point.w * -g.d;
  for (int i = 0; i < 3; ++i) value += point.x[i] * g.n[i];
  return value.sign();
}

int side_of_crossing(Vec3 a, Vec3 b, const Plane& crossed, const Plane& plane) {
  const std::int64_t ga[3] = {to_grid_integer(a.x), to_grid_integer(a.y), to_grid_integer(a.z)};
  const std::int64_t gb[3] = {to_grid_integer(b.x), to_grid_integer(b.y), to_grid_integer(b.z)};
  const GridPlane c = to_grid(crossed);
  const GridPlane g = to_grid(plane);
  // At a + t (b - a) with t = c(a) / (c(a) - c(b)), plane is [g(b) c(a) - g(a) c(b)] / (c(a) -
  // c(b)).
  const Int128 ca = evaluate(c, ga);
  const Int128 cb = evaluate(c, gb);
  const Wide numerator = Wide(evaluate(g, gb)) * Wide(ca) - Wide(evaluate(g, ga)) * Wide(cb);
  return ca > cb ? numerator.sign() : -numerator.sign();
}

int orientation_of_normals(const Plane& p, const Plane& q, const Plane& r) {
  const double value = glm::dot(p.normal, glm::cross(q.normal, r.normal));
  if (std::abs(value) > kSideError) return sign(value);
  const GridPlane g = to_grid(p);
  const auto qr = cross(to_grid(q), to_grid(r));
  Wide w = 0;
  for (int i = 0; i < 3; ++i) w += Wide(qr[i]) * g.n[i];
  return w.sign();
}

ApproximatePoint intersection_point(const Plane& p, const Plane& q, const Plane& r) {
  constexpr double kUnit = 0x1p-53;  // of rounding
  const auto largest = [](Vec3 x) {
    return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  };
  const Vec3 qr = glm::cross(q.normal, r.normal);
  const double w = glm::dot(p.normal, qr);
  if (std::abs(w) > 1.0 / 6) {
    const Vec3 rp = glm::cross(r.normal, p.normal);
    const Vec3 pq = glm::cross(p.normal, q.normal);
    const Vec3 x = (p.offset * qr + q.offset * rp + r.offset * pq) / w;
    // Numerators err by less than 28 units and w by less than 7; both are divided by |w|, and the
    // quotient is rounded. Inside the cube that is at most 241 units, less than 2^-45.
    const double size = largest(x);
    return {x, (32 + 8 * size) * kUnit / std::abs(w) + size * kUnit};
  }
  const Homogeneous point = intersect(to_grid(p), to_grid(q), to_grid(r));
  assert(point.w.sign() > 0);
  const Vec3 x{ratio(point.x[0], point.w), ratio(point.x[1], point.w), ratio(point.x[2], point.w)};
  // Both integers are rounded to doubles limb by limb, and so is their quotient.
  return {x, 16 * kUnit * largest(x)};
}

ApproximatePoint crossing_point(Vec3 a, Vec3 b, const Plane& crossed) {
  const std::int64_t ga[3] = {to_grid_integer(a.x), to_grid_integer(a.y), to_grid_integer(a.z)};
  const std::int64_t gb[3] = {to_grid_integer(b.x), to_grid_integer(b.y), to_grid_integer(b.z)};
  const GridPlane c = to_grid(crossed);
  // The two distances are exact integers, so the parameter has a relative error of a few roundings.
  const auto ca = static_cast<double>(evaluate(c, ga));
  const auto cb = static_cast<double>(evaluate(c, gb));
  const double t = ca / (ca - cb);
  return {a + (b - a) * t, 0x1p-49};
}

RoundedPoint rounded_intersection(const Plane& p, const Plane& q, const Plane& r, int bits) {
  // In doubles first: usually the rounding is not in doubt.
  const ApproximatePoint approximate = intersection_point(p, q, r);
  std::int64_t rounded[3];
  bool certain = true;
  for (int i = 0; i < 3 && certain; ++i) {
    const double lower = std::floor(std::ldexp(approximate.position[i] - approximate.error, bits));
    const double upper = std::floor(std::ldexp(approximate.position[i] + approximate.error, bits));
    certain = lower == upper;
    rounded[i] = static_cast<std::int64_t>(lower);
  }
  if (!certain) {
    const Homogeneous point = intersect(to_grid(p), to_grid(q), to_grid(r));
    for (int i = 0; i < 3; ++i) rounded[i] = rounded_ratio(point.x[i], point.w, bits);
  }
  return {rounded[0], rounded[1], rounded[2]};
}

RoundedLine rounded_line(const Plane& p, const Plane& q) {
  constexpr int kLineBits = 50;
  const GridPlane gp = to_grid(p);
  const GridPlane gq = to_grid(q);
  const auto direction = cross(gp, gq);
  const auto magnitude = [](Int128 value) { return value < 0 ? -value : value; };
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (magnitude(direction[i]) > magnitude(direction[axis])) axis = i;
  }
  assert(direction[axis] != 0);
  const int turn = direction[axis] < 0 ? -1 : 1;
  const Wide denominator = Wide(magnitude(direction[axis]));
  RoundedLine line;
  line.axis = axis;
  for (int k = 1; k < 3; ++k) {
    line.coordinates[k - 1] =
        rounded_ratio(Wide(direction[(axis + k) % 3]) * turn, denominator, kLineBits);
  }
  // The moment d_p n_q - d_q n_p is the direction times a point of the line (up to sign).
  for (int i = 0; i < 3; ++i) {
    const Int128 moment = static_cast<Int128>(gp.d) * gq.n[i] - static_cast<Int128>(gq.d) * gp.n[i];
    line.coordinates[2 + i] = rounded_ratio(Wide(moment) * turn, denominator, kLineBits);
  }
  return line;
}

}  // namespace spoctree
