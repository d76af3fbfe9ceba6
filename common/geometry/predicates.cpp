#include "common/geometry/predicates.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cassert>
#include <glm/geometric.hpp>

#include "common/geometry/int256.hpp"

namespace spoctree {

namespace {

struct GridPlane {
  std::int64_t n[3];
  std::int64_t d;
};

std::int64_t to_grid_integer(double value) { return static_cast<std::int64_t>(value * 0x1p52); }

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
  Int256 x[3];
  Int256 w;
};

Homogeneous intersect(const GridPlane& p, const GridPlane& q, const GridPlane& r) {
  const auto qr = cross(q, r);
  const auto rp = cross(r, p);
  const auto pq = cross(p, q);
  Homogeneous point;
  for (int i = 0; i < 3; ++i) {
    point.w += Int256(qr[i]) * p.n[i];
    point.x[i] = Int256(qr[i]) * p.d;
    point.x[i] += Int256(rp[i]) * q.d;
    point.x[i] += Int256(pq[i]) * r.d;
  }
  if (point.w.sign() < 0) {
    point.w = -point.w;
    for (Int256& x : point.x) x = -x;
  }
  return point;
}

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
  // The nearest grid point is evaluated exactly, in units of 2^-104; the rest of the point, at most
  // half a grid step per axis, in doubles.
  if (size <= 0x1p10) {
    std::int64_t grid_point[3];
    double rest = 0;
    bool on_grid = true;  // a rest of 0 may be what rounding left of another
    for (int i = 0; i < 3; ++i) {
      const double scaled = point[i] * 0x1p52;
      const double rounded = std::nearbyint(scaled);
      grid_point[i] = static_cast<std::int64_t>(rounded);
      rest += plane.normal[i] * 0x1p52 * (scaled - rounded);
      on_grid &= scaled == rounded;
    }
    const Int128 at_grid_point = evaluate(to_grid(plane), grid_point);
    if (on_grid) return sign(at_grid_point);
    // |rest| < 2^53 and errs by less than 4.
    if (at_grid_point > Int128{1} << 54) return 1;
    if (at_grid_point < -(Int128{1} << 54)) return -1;
    const double sum = static_cast<double>(at_grid_point) + rest;
    if (std::abs(sum) > 64) return sign(sum);
  }
  using Rational = boost::multiprecision::cpp_rational;
  Rational sum = -Rational(plane.offset);
  for (int i = 0; i < 3; ++i) sum += Rational(plane.normal[i]) * Rational(point[i]);
  return sign(sum);
}

int determinant_sign(const Plane& p, const Plane& q, const Plane& r, const Plane& s) {
  // By minors of the first two rows and of the last two.
  const GridPlane rows[4] = {to_grid(p), to_grid(q), to_grid(r), to_grid(s)};
  const auto minor = [&](int row, int i, int j) {
    const auto at = [&](int k, int column) {
      return static_cast<Int128>(column < 3 ? rows[k].n[column] : rows[k].d);
    };
    return at(row, i) * at(row + 1, j) - at(row, j) * at(row + 1, i);
  };
  Int256 determinant = Int256::product(minor(0, 0, 1), minor(2, 2, 3));
  determinant += Int256::product(-minor(0, 0, 2), minor(2, 1, 3));
  determinant += Int256::product(minor(0, 0, 3), minor(2, 1, 2));
  determinant += Int256::product(minor(0, 1, 2), minor(2, 0, 3));
  determinant += Int256::product(-minor(0, 1, 3), minor(2, 0, 2));
  determinant += Int256::product(minor(0, 2, 3), minor(2, 0, 1));
  return determinant.sign();
}

int side_of_intersection(const Plane& p, const Plane& q, const Plane& r, const Plane& plane) {
  // The plane's value is minus one determinant over the other.
  const int orientation = orientation_of_normals(p, q, r);
  assert(orientation != 0);
  return -orientation * determinant_sign(p, q, r, plane);
}

int side_of_crossing(Vec3 a, Vec3 b, const Plane& crossed, const Plane& plane) {
  const std::int64_t ga[3] = {to_grid_integer(a.x), to_grid_integer(a.y), to_grid_integer(a.z)};
  const std::int64_t gb[3] = {to_grid_integer(b.x), to_grid_integer(b.y), to_grid_integer(b.z)};
  const GridPlane c = to_grid(crossed);
  const GridPlane g = to_grid(plane);
  // At a + t (b - a) with t = c(a) / (c(a) - c(b)), the plane's value is
  // [g(b) c(a) - g(a) c(b)] / (c(a) - c(b)).
  const Int128 ca = evaluate(c, ga);
  const Int128 cb = evaluate(c, gb);
  Int256 numerator = Int256(evaluate(g, gb)) * ca;
  numerator += -(Int256(evaluate(g, ga)) * cb);
  return ca > cb ? numerator.sign() : -numerator.sign();
}

int orientation_of_normals(const Plane& p, const Plane& q, const Plane& r) {
  const double value = glm::dot(p.normal, glm::cross(q.normal, r.normal));
  if (std::abs(value) > kSideError) return sign(value);
  const GridPlane g = to_grid(p);
  const auto qr = cross(to_grid(q), to_grid(r));
  Int256 w;
  for (int i = 0; i < 3; ++i) w += Int256(qr[i]) * g.n[i];
  return w.sign();
}

using LongVec3 = glm::vec<3, long double>;

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
  // The same with 64 bits: errors of 2^-64 times the constants above, so |w| may be 2^11 times
  // smaller at no loss.
  if (std::abs(w) > 0x1p-12) {
    const LongVec3 np(p.normal);
    const LongVec3 nq(q.normal);
    const LongVec3 nr(r.normal);
    const LongVec3 long_qr = glm::cross(nq, nr);
    const long double long_w = glm::dot(np, long_qr);
    const auto offset = [](const Plane& plane) { return static_cast<long double>(plane.offset); };
    const Vec3 x(
        (offset(p) * long_qr + offset(q) * glm::cross(nr, np) + offset(r) * glm::cross(np, nq)) /
        long_w);
    const double size = largest(x);
    return {x, (32 + 8 * size) * kUnit * 0x1p-11 / (std::abs(w) - 7 * kUnit) + 3 * size * kUnit};
  }
  const Homogeneous point = intersect(to_grid(p), to_grid(q), to_grid(r));
  assert(point.w.sign() > 0);
  const long double exact_w = point.w.to_long_double();
  Vec3 x;
  for (int i = 0; i < 3; ++i) {
    x[i] = static_cast<double>(point.x[i].to_long_double() / exact_w);
  }
  // Half of this for x, the other half for who adds the error to x and rounds once more.
  return {x, 4 * kUnit * largest(x)};
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

}  // namespace spoctree
