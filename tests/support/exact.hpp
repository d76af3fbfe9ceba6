// Plane geometry in rational numbers, by textbook elimination: what the predicates are judged by.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

#include "common/geometry/plane.hpp"

namespace spoctree {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;

inline RationalPoint to_rational(Vec3 point) {
  return {Rational(point.x), Rational(point.y), Rational(point.z)};
}

/// normal . point - offset.
Rational exact_value(const Plane& plane, const RationalPoint& point);

/// -1, 0 or 1.
int exact_sign(const Rational& value);

/// floor(value * 2^bits).
boost::multiprecision::cpp_int exact_floor(const Rational& value, int bits);

/// The point in which three planes meet, if it is one (Gaussian elimination).
std::optional<RationalPoint> exact_intersection(const Plane& p, const Plane& q, const Plane& r);

/// The largest distance of two points along an axis.
Rational exact_distance(const RationalPoint& a, const RationalPoint& b);

}  // namespace spoctree
