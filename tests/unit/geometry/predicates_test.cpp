// Exact signs and error bounds, judged by rational numbers on easy and on degenerate inputs.
#include "common/geometry/predicates.hpp"

#include <gtest/gtest.h>

#include "tests/support/exact.hpp"
#include "tests/support/grid_planes.hpp"

namespace spoctree {
namespace {

struct Triple {
  Plane p, q, r;
};

/// Any of: random planes, planes through a common point, walls, nearly parallel planes that meet
/// in a point of the cube. `common` is set if the planes meet there exactly.
Triple random_triple(Random& random, std::optional<Vec3>& common) {
  common.reset();
  const auto wall_at = [&](int axis, double coordinate) {
    Plane plane;
    plane.normal[axis] = random.chance(0.5) ? 1 : -1;
    plane.offset = coordinate * plane.normal[axis];
    return plane;
  };
  switch (random.below(6)) {
    case 0: {  // through a common point
      const Vec3 point = random_grid_point(random, 10);
      common = point;
      return {random_plane_exactly_through(random, point, 10),
              random_plane_exactly_through(random, point, 10),
              random_plane_exactly_through(random, point, 10)};
    }
    case 1: {  // nearly parallel, through a common point
      const Vec3 point = random_grid_point(random, 2);
      common = point;
      const Plane plane = random_plane_exactly_through(random, point, 2);
      return {plane, nearly_parallel_plane_through(random, plane, point),
              nearly_parallel_plane_through(random, plane, point)};
    }
    case 2: {  // two nearly parallel ones and one across
      const Vec3 point = random_grid_point(random, 2);
      common = point;
      const Plane plane = random_plane_exactly_through(random, point, 2);
      return {plane, random_plane_exactly_through(random, point, 2),
              nearly_parallel_plane_through(random, plane, point)};
    }
    case 3: {  // at small angles, rounded: near a point
      const Vec3 point = random_vector(random, 1);
      const Vec3 normal = random_direction(random);
      const double angle = std::ldexp(1.0, -random_integer(random, 1, 30));
      return {grid_plane_through(normal, point),
              grid_plane_through(normal + angle * random_direction(random), point),
              grid_plane_through(normal + angle * random_direction(random), point)};
    }
    case 4: {  // walls
      const Vec3 point = random_grid_point(random, 10);
      common = point;
      return {wall_at(0, point.x),
              random.chance(0.5) ? wall_at(1, point.y)
                                 : random_plane_exactly_through(random, point, 10),
              wall_at(2, point.z)};
    }
    default: {
      const auto plane = [&] {
        return grid_plane_through(random_direction(random), random_vector(random, 1));
      };
      const Plane p = plane();
      const Plane q = plane();
      return {p, q, plane()};
    }
  }
}

bool is_in_unit_cube(const RationalPoint& point) {
  return abs(point[0]) <= 1 && abs(point[1]) <= 1 && abs(point[2]) <= 1;
}

Plane shifted(const Plane& plane, int steps) {
  return {plane.normal, plane.offset + steps * 0x1p-52};
}

TEST(SideOfPoint, IsExactForGridPointsOnAndBesidePlanes) {
  Random random(1);
  for (int k = 0; k < 3000; ++k) {
    const Vec3 point = random_grid_point(random, 10);
    const Plane plane = random_plane_exactly_through(random, point, 10);
    EXPECT_EQ(side_of_point(plane, point), 0);
    EXPECT_EQ(side_of_point(plane.flipped(), point), 0);
    EXPECT_EQ(side_of_point(shifted(plane, 1), point), -1);
    EXPECT_EQ(side_of_point(shifted(plane, -1), point), 1);
    EXPECT_EQ(side_of_any_point(plane, point), 0);
    EXPECT_EQ(side_of_any_point(shifted(plane, 1), point), -1);
    EXPECT_EQ(side_of_any_point(shifted(plane, -1), point), 1);
    // Grid points in the layer of rounding around the plane.
    Vec3 near = point;
    for (int i = 0; i < 3; ++i) near[i] += random_integer(random, -3, 3) * 0x1p-52;
    const int expected = exact_sign(exact_value(plane, to_rational(near)));
    EXPECT_EQ(side_of_point(plane, near), expected);
    EXPECT_EQ(side_of_any_point(plane, near), expected);
    EXPECT_EQ(side_of_point(plane.flipped(), near), -expected);
  }
}

TEST(SideOfPoint, IsExactForRandomGridPointsNearAndFarFromPlanes) {
  Random random(2);
  for (int k = 0; k < 5000; ++k) {
    Vec3 point = random_grid_point(random, 52);
    const Plane plane = grid_plane_through(random_direction(random), point);
    if (k % 4 == 0) point = random_grid_point(random, 52);
    if (k % 4 == 1) point = random_grid_point(random, 42, 1000);
    EXPECT_EQ(side_of_point(plane, point), exact_sign(exact_value(plane, to_rational(point))));
  }
}

TEST(SideOfAnyPoint, IsExactForDoublesOffTheGrid) {
  Random random(3);
  for (int k = 0; k < 5000; ++k) {
    const Plane plane = grid_plane_through(random_direction(random), random_vector(random, 0.5));
    // A point of the plane, as near as doubles come: solve for the last coordinate.
    Vec3 point = random_vector(random, std::ldexp(1.0, -random_integer(random, 0, 60)));
    const int axis = random_integer(random, 0, 2);
    if (std::abs(plane.normal[axis]) < 0.1) continue;
    point[axis] = 0;
    double rest = plane.offset;
    for (int i = 0; i < 3; ++i) rest -= plane.normal[i] * point[i];
    point[axis] = rest / plane.normal[axis];
    for (int step = 0; step < 3; ++step) {
      EXPECT_EQ(side_of_any_point(plane, point),
                exact_sign(exact_value(plane, to_rational(point))));
      point[axis] = std::nextafter(point[axis], 10.0);
    }
  }
}

TEST(SideOfAnyPoint, SeesTheSmallestAndTheLargestDoubles) {
  Plane wall;
  wall.normal.x = 1;
  EXPECT_EQ(side_of_any_point(wall, {5e-324, 0, 0}), 1);
  EXPECT_EQ(side_of_any_point(wall, {-5e-324, 1e300, 0}), -1);
  EXPECT_EQ(side_of_any_point(wall, {0, 1e300, -1e300}), 0);
  EXPECT_EQ(side_of_any_point(wall, {-0.0, 0, 0}), 0);
  wall.offset = 0.5;
  EXPECT_EQ(side_of_any_point(wall, {std::nextafter(0.5, 0.0), 1, 1}), -1);
  EXPECT_EQ(side_of_any_point(wall, {0.5, 1, 1}), 0);
  EXPECT_EQ(side_of_any_point(wall, {std::nextafter(0.5, 1.0), 1, 1}), 1);
  Random random(4);
  constexpr double kMax = std::numeric_limits<double>::max();
  for (int k = 0; k < 500; ++k) {
    const Plane plane = grid_plane_through(random_direction(random), random_vector(random, 0.5));
    for (const Vec3 point : {Vec3{kMax, kMax, kMax}, Vec3{kMax, -kMax, kMax}, Vec3{-kMax, kMax, 0},
                             Vec3{5e-324, -5e-324, 5e-324}, random_vector(random, 1e300)}) {
      EXPECT_EQ(side_of_any_point(plane, point),
                exact_sign(exact_value(plane, to_rational(point))));
    }
  }
}

TEST(SideOfAnyPoint, IsExactWhereRoundedProductsCancel) {
  // n.x x + n.y y = 0 in doubles, but not exactly: nothing but the exact sum knows the side.
  Random random(41);
  int cancelled = 0;
  for (int k = 0; k < 20000; ++k) {
    const Plane plane = grid_plane_through(random_direction(random), Vec3{0.0});
    Vec3 point{0.0};
    point.x = random.between(-1, 1) * std::ldexp(1.0, -random_integer(random, 1, 200));
    point.y = -(plane.normal.x * point.x) / plane.normal.y;
    if (k % 2 == 0) {
      // The same around a grid point of the plane.
      point.x = std::ldexp(point.x, -60);
      point.y = std::ldexp(point.y, -60);
    }
    cancelled += plane.normal.x * point.x + plane.normal.y * point.y == 0;
    EXPECT_EQ(side_of_any_point(plane, point), exact_sign(exact_value(plane, to_rational(point))));
  }
  EXPECT_GT(cancelled, 5000);
}

TEST(SideOfIntersection, IsExactForEasyAndDegenerateTriples) {
  Random random(5);
  int on_plane = 0;
  for (int k = 0; k < 3000; ++k) {
    std::optional<Vec3> common;
    const Triple triple = random_triple(random, common);
    const auto& [p, q, r] = triple;
    const auto point = exact_intersection(p, q, r);
    if (!point) continue;
    if (common) {
      EXPECT_EQ(*point, to_rational(*common));
    }
    std::vector<Plane> others{
        p, q.flipped(), grid_plane_through(random_direction(random), random_vector(random, 1)),
        shifted(p, 1), shifted(r, -1)};
    if (common) {
      others.push_back(random_plane_exactly_through(random, *common, 10));
      others.push_back(shifted(others.back(), 1));
      others.push_back(shifted(others.back(), -2));
    }
    for (const Plane& other : others) {
      const int expected = exact_sign(exact_value(other, *point));
      on_plane += expected == 0;
      EXPECT_EQ(side_of_intersection(p, q, r, other), expected);
      EXPECT_EQ(side_of_intersection(r, p.flipped(), q, other), expected);
      EXPECT_EQ(side_of_intersection(q, p, r, other.flipped()), -expected);
    }
  }
  EXPECT_GT(on_plane, 5000);
}

TEST(SideOfIntersection, HoldsTheLargestDeterminants) {
  // Normals far longer than any valid one: every product is as large as it can get.
  Random random(6);
  const auto large_plane = [&] {
    const auto large = [&](double limit) {
      const double magnitude = limit - random_integer(random, 0, 5) * 0x1p-52;
      return random.chance(0.5) ? magnitude : -magnitude;
    };
    const double x = large(1);
    const double y = large(1);
    const double z = large(1);
    return Plane{{x, y, z}, large(2)};
  };
  int tested = 0;
  for (int k = 0; k < 4000; ++k) {
    const Plane p = large_plane();
    const Plane q = large_plane();
    const Plane r = large_plane();
    const Plane s = large_plane();
    const auto point = exact_intersection(p, q, r);
    if (!point) continue;
    ++tested;
    EXPECT_EQ(side_of_intersection(p, q, r, s), exact_sign(exact_value(s, *point)));
  }
  EXPECT_GT(tested, 3000);
}

TEST(SideOfCrossing, IsExactForSegmentsThroughPlanes) {
  Random random(7);
  int on_plane = 0;
  for (int k = 0; k < 6000; ++k) {
    Vec3 a = random_grid_point(random, 52);
    Vec3 b = random_grid_point(random, 52);
    Plane crossed = grid_plane_through(random_direction(random), random_vector(random, 0.5));
    std::vector<Plane> others{
        grid_plane_through(random_direction(random), random_vector(random, 1))};
    if (k % 2 == 0) {
      // Through a known point of the segment.
      const Vec3 point = random_grid_point(random, 10, 0.5);
      const Vec3 step = random_grid_point(random, 10, 1.0 / 16);
      a = point + step * static_cast<double>(random.below(8));
      b = point - step * static_cast<double>(1 + random.below(7));
      crossed = random_plane_exactly_through(random, point, 10);
      others.push_back(random_plane_exactly_through(random, point, 10));
      others.push_back(shifted(others.back(), 1));
      others.push_back(shifted(others.back(), -2));
    } else if (k % 4 == 1) {
      // Short, and around a plane.
      crossed = grid_plane_through(random_direction(random), a);
      for (int i = 0; i < 3; ++i) b[i] = a[i] + random_integer(random, -3, 3) * 0x1p-52;
    }
    const Rational ca = exact_value(crossed, to_rational(a));
    const Rational cb = exact_value(crossed, to_rational(b));
    if (ca * cb > 0 || ca == cb) continue;
    const Rational t = ca / (ca - cb);
    RationalPoint point;
    for (int i = 0; i < 3; ++i) {
      point[static_cast<std::size_t>(i)] = Rational(a[i]) + t * (Rational(b[i]) - Rational(a[i]));
    }
    others.push_back(crossed);
    for (const Plane& other : others) {
      const int expected = exact_sign(exact_value(other, point));
      on_plane += expected == 0;
      EXPECT_EQ(side_of_crossing(a, b, crossed, other), expected);
      EXPECT_EQ(side_of_crossing(b, a, crossed, other), expected);
      EXPECT_EQ(side_of_crossing(a, b, crossed.flipped(), other.flipped()), -expected);
    }
    const ApproximatePoint near = crossing_point(a, b, crossed);
    EXPECT_LE(exact_distance(to_rational(near.position), point), Rational(near.error));
    EXPECT_LE(near.error, 0x1p-45);
  }
  EXPECT_GT(on_plane, 5000);
}

TEST(OrientationOfNormals, IsExactForEasyAndDegenerateTriples) {
  Random random(8);
  for (int k = 0; k < 6000; ++k) {
    std::optional<Vec3> common;
    Triple triple = random_triple(random, common);
    if (k % 7 == 0) {
      // All three contain one direction: the determinant is 0.
      const Vec3 point = random_grid_point(random, 7);
      const int direction[3] = {random_integer(random, -1, 1), random_integer(random, -1, 1), 1};
      triple = {random_plane_exactly_through_line(random, point, 7, direction),
                random_plane_exactly_through_line(random, point, 7, direction),
                random_plane_exactly_through_line(random, point, 7, direction)};
      EXPECT_FALSE(exact_intersection(triple.p, triple.q, triple.r));
    }
    // The determinant by Sarrus' rule.
    Rational determinant = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int l = (i + 2) % 3;
      determinant += Rational(triple.p.normal[i]) * Rational(triple.q.normal[j]) *
                     Rational(triple.r.normal[l]);
      determinant -= Rational(triple.p.normal[l]) * Rational(triple.q.normal[j]) *
                     Rational(triple.r.normal[i]);
    }
    const int expected = exact_sign(determinant);
    EXPECT_EQ(orientation_of_normals(triple.p, triple.q, triple.r), expected);
    EXPECT_EQ(orientation_of_normals(triple.q, triple.p, triple.r), -expected);
    EXPECT_EQ(orientation_of_normals(triple.q, triple.r, triple.p), expected);
    EXPECT_EQ(orientation_of_normals(triple.p.flipped(), triple.q, triple.r), -expected);
    if (k % 7 == 0) {
      EXPECT_EQ(expected, 0);
    }
  }
}

TEST(IntersectionPoint, LiesWithinItsErrorOfTheExactPoint) {
  Random random(9);
  int in_cube = 0;
  for (int k = 0; k < 6000; ++k) {
    std::optional<Vec3> common;
    const auto [p, q, r] = random_triple(random, common);
    const auto point = exact_intersection(p, q, r);
    if (!point) continue;
    const ApproximatePoint near = intersection_point(p, q, r);
    ASSERT_LE(exact_distance(to_rational(near.position), *point), Rational(near.error));
    if (!is_in_unit_cube(*point)) continue;
    ++in_cube;
    EXPECT_LE(near.error, 0x1p-45);
  }
  EXPECT_GT(in_cube, 3000);
}

TEST(IntersectionPoint, KeepsItsPromiseWhereTheDeterminantIsSmall) {
  // Determinants around the bound between the two ways of computing.
  Random random(10);
  int in_cube = 0;
  for (int k = 0; k < 6000; ++k) {
    const Vec3 point = random_vector(random, 1);
    const Vec3 normal = random_direction(random);
    const double angle = random.between(0.1, 0.7);
    const Plane p = grid_plane_through(normal, point);
    const Plane q = grid_plane_through(normal + angle * random_direction(random), point);
    const Plane r = grid_plane_through(normal + angle * random_direction(random), point);
    const auto exact = exact_intersection(p, q, r);
    if (!exact) continue;
    const ApproximatePoint near = intersection_point(p, q, r);
    ASSERT_LE(exact_distance(to_rational(near.position), *exact), Rational(near.error));
    if (!is_in_unit_cube(*exact)) continue;
    ++in_cube;
    EXPECT_LE(near.error, 0x1p-45);
  }
  EXPECT_GT(in_cube, 3000);
}

}  // namespace
}  // namespace spoctree
