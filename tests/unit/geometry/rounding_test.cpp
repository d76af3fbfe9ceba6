// Canonical names of points and lines: functions of the exact point or line alone.
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "common/geometry/predicates.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/grid_planes.hpp"

namespace spoctree {
namespace {

RoundedPoint expected_rounding(const RationalPoint& point, int bits) {
  const auto rounded = [&](std::size_t i) {
    return exact_floor(point[i], bits).convert_to<std::int64_t>();
  };
  return {rounded(0), rounded(1), rounded(2)};
}

Plane wall_at(int axis, double coordinate) {
  Plane plane;
  plane.normal[axis] = 1;
  plane.offset = coordinate;
  return plane;
}

TEST(RoundedIntersection, RoundsTheExactPointDown) {
  Random random(1);
  int tested = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 near = random_vector(random, 1);
    const double spread = std::ldexp(1.0, -random_integer(random, 0, 25));
    const Vec3 normal = random_direction(random);
    const Plane p = grid_plane_through(normal, near);
    const Plane q = grid_plane_through(normal + spread * random_direction(random), near);
    const Plane r = grid_plane_through(normal + spread * random_direction(random), near);
    const auto point = exact_intersection(p, q, r);
    if (!point || abs((*point)[0]) > 1 || abs((*point)[1]) > 1 || abs((*point)[2]) > 1) continue;
    ++tested;
    for (const int bits : {1, 20, 44, 46, 52, 60}) {
      const RoundedPoint expected = expected_rounding(*point, bits);
      EXPECT_EQ(rounded_intersection(p, q, r, bits), expected);
      EXPECT_EQ(rounded_intersection(r, p.flipped(), q, bits), expected);
    }
  }
  EXPECT_GT(tested, 1500);
}

TEST(RoundedIntersection, IsOneNameForAllPlanesThroughAPoint) {
  Random random(2);
  for (int k = 0; k < 20; ++k) {
    // Points on the rounding's own steps are the hardest: a hair below is another name.
    const int point_bits = k % 2 == 0 ? 2 : 10;
    const Vec3 point = random_grid_point(random, point_bits);
    std::vector<Plane> planes;
    for (int i = 0; i < 8; ++i) {
      planes.push_back(random_plane_exactly_through(random, point, point_bits));
    }
    for (int axis = 0; axis < 3; ++axis) planes.push_back(wall_at(axis, point[axis]));
    if (point_bits == 2) {
      for (int i = 0; i < 3; ++i) {
        planes.push_back(nearly_parallel_plane_through(random, planes[0], point));
      }
    }
    for (const int bits : {1, 10, 40, 50, 52, 60}) {
      const RoundedPoint expected = expected_rounding(to_rational(point), bits);
      for (std::size_t a = 0; a < planes.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          for (std::size_t c = 0; c < b; ++c) {
            if (orientation_of_normals(planes[a], planes[b], planes[c]) == 0) continue;
            ASSERT_EQ(rounded_intersection(planes[a], planes[b], planes[c], bits), expected);
          }
        }
      }
    }
  }
}

TEST(RoundedIntersection, IsMonotoneAlongALine) {
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    const Vec3 start = random_vector(random, 0.5);
    const Plane p = grid_plane_through(random_direction(random), start);
    const Plane q = grid_plane_through(random_direction(random), start);
    // Parallel cuts in order of their offsets, a step of the grid apart.
    Plane cut = grid_plane_through(random_direction(random), start);
    if (orientation_of_normals(p, q, cut) == 0) continue;
    std::vector<RoundedPoint> names;
    for (int i = 0; i < 50; ++i) {
      const auto point = exact_intersection(p, q, cut);
      if (abs((*point)[0]) > 1 || abs((*point)[1]) > 1 || abs((*point)[2]) > 1) break;
      names.push_back(rounded_intersection(p, q, cut, 50));
      cut.offset += 0x1p-52;
    }
    if (names.size() < 2) continue;
    const auto direction = [](std::int64_t from, std::int64_t to) {
      return (to > from) - (to < from);
    };
    int seen[3] = {0, 0, 0};
    for (std::size_t i = 1; i < names.size(); ++i) {
      const int turns[3] = {direction(names[i - 1].x, names[i].x),
                            direction(names[i - 1].y, names[i].y),
                            direction(names[i - 1].z, names[i].z)};
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(turns[axis] * seen[axis], 0);
        if (turns[axis] != 0) seen[axis] = turns[axis];
      }
    }
  }
}

TEST(RoundedLine, IsOneNameForAllPairsOfPlanesThroughALine) {
  Random random(4);
  const int directions[][3] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1},  {1, 1, 0},  {1, -1, 0}, {0, 1, 1},
                               {1, 1, 1}, {1, -1, 1}, {1, 2, 3},  {-3, 2, 1}, {2, 2, -1}, {3, 3, 1},
                               {0, 2, 3}, {-1, 1, 1}, {3, -3, 3}, {2, 0, -1}};
  for (const auto& direction : directions) {
    for (int k = 0; k < 5; ++k) {
      const Vec3 point = random_grid_point(random, 7, 0.5);
      std::vector<Plane> planes;
      for (int i = 0; i < 8; ++i) {
        planes.push_back(random_plane_exactly_through_line(random, point, 7, direction));
        if (i % 2 == 0) planes.back() = planes.back().flipped();
      }
      for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) planes.push_back(wall_at(axis, point[axis]));
      }
      const RoundedLine name = rounded_line(planes[0], planes[1]);
      EXPECT_NE(direction[name.axis], 0);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(std::abs(direction[axis]), std::abs(direction[name.axis]));
      }
      for (const Plane& p : planes) {
        for (const Plane& q : planes) {
          if (&p == &q || p.normal == q.normal || p.normal == -q.normal) continue;
          ASSERT_EQ(rounded_line(p, q), name);
        }
      }
    }
  }
}

TEST(RoundedLine, HoldsThePlueckerCoordinatesOfTheLine) {
  Random random(5);
  int tested = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 near = random_vector(random, 1);
    const Vec3 normal = random_direction(random);
    const double spread = std::ldexp(1.0, -random_integer(random, 0, 25));
    const Plane p = grid_plane_through(normal, near);
    const Plane q = grid_plane_through(normal + spread * random_direction(random), near);
    // Two points of the line, on two walls.
    const RoundedLine name = rounded_line(p, q);
    const auto a = exact_intersection(p, q, wall_at(name.axis, 0));
    const auto b = exact_intersection(p, q, wall_at(name.axis, 1));
    ASSERT_TRUE(a && b);
    RationalPoint direction;
    for (std::size_t i = 0; i < 3; ++i) direction[i] = (*b)[i] - (*a)[i];
    const auto axis = static_cast<std::size_t>(name.axis);
    EXPECT_EQ(direction[axis], 1);
    bool meets_cube = false;
    {
      // The parameters at which the line is within the cube, axis by axis.
      Rational from = -1;
      Rational to = 1;
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LE(abs(direction[i]), 1);
        if (direction[i] == 0) continue;
        const Rational one = (1 - (*a)[i]) / direction[i];
        const Rational other = (-1 - (*a)[i]) / direction[i];
        from = std::max(from, std::min(one, other));
        to = std::min(to, std::max(one, other));
      }
      meets_cube = from <= to;
    }
    if (!meets_cube) continue;
    ++tested;
    const auto name_of = [](const Rational& value) {
      return exact_floor(value, 50).convert_to<std::int64_t>();
    };
    for (std::size_t i = 1; i < 3; ++i) {
      EXPECT_EQ(name.coordinates[i - 1], name_of(direction[(axis + i) % 3]));
    }
    // The moment, direction x point, up to the sign that the comment leaves open.
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational moment =
          direction[(i + 1) % 3] * (*a)[(i + 2) % 3] - direction[(i + 2) % 3] * (*a)[(i + 1) % 3];
      EXPECT_TRUE(name.coordinates[2 + i] == name_of(moment) ||
                  name.coordinates[2 + i] == name_of(Rational(-moment)));
    }
  }
  EXPECT_GT(tested, 1200);
}

TEST(RoundedLine, TellsNeighbouringLinesApart) {
  Random random(6);
  std::set<std::tuple<int, std::int64_t, std::int64_t, std::int64_t, std::int64_t, std::int64_t>>
      names;
  const Plane p = grid_plane_through(random_direction(random), {0.1, 0.2, 0.3});
  Plane q = grid_plane_through(random_direction(random), {0.1, 0.2, 0.3});
  for (int k = 0; k < 100; ++k) {
    const RoundedLine name = rounded_line(p, q);
    names.emplace(name.axis, name.coordinates[0], name.coordinates[1], name.coordinates[2],
                  name.coordinates[3], name.coordinates[4]);
    q.offset += 0x1p-49;
  }
  EXPECT_EQ(names.size(), 100u);
}

}  // namespace
}  // namespace spoctree
