// Inside, outside, on the boundary, and how far away: against shapes whose answers are known.
#include "server/solid/solid_queries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "server/solid/box_tree.hpp"
#include "server/solid/triangle_distance.hpp"
#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;
using Side = SolidQueries::Side;

// A box with known universe coordinates, for points of the test's choosing.
struct BoxOracle {
  Vec3 lower, upper;

  Side side_of(Vec3 p) const {
    bool is_on = false;
    for (int i = 0; i < 3; ++i) {
      if (p[i] < lower[i] || p[i] > upper[i]) return Side::Out;
      is_on = is_on || p[i] == lower[i] || p[i] == upper[i];
    }
    return is_on ? Side::On : Side::In;
  }
  double distance(Vec3 p) const {
    const Vec3 outside = glm::max(glm::max(lower - p, p - upper), Vec3{0.0});
    if (outside != Vec3{0.0}) return glm::length(outside);
    const Vec3 inside = glm::min(p - lower, upper - p);
    return std::min({inside.x, inside.y, inside.z});
  }
};

class BoxQueries : public ::testing::Test {
 protected:
  BoxQueries() : solid_(import_it(box({0, 0, 0}, {1, 2, 4}))), queries_(solid_) {
    oracle_.lower = solid_.vertices[0];
    oracle_.upper = solid_.vertices[7];
  }
  Solid solid_;
  SolidQueries queries_;
  BoxOracle oracle_{};
};

TEST_F(BoxQueries, AgreeOnALatticeThatHitsEveryCornerEdgeAndDiagonal) {
  const Vec3 size = oracle_.upper - oracle_.lower;
  for (int i = -1; i <= 5; ++i) {
    for (int j = -1; j <= 5; ++j) {
      for (int k = -1; k <= 5; ++k) {
        // Quarters of powers of two: exact.
        const Vec3 p = oracle_.lower + size * Vec3{i / 4.0, j / 4.0, k / 4.0};
        EXPECT_EQ(queries_.side_of(p), oracle_.side_of(p)) << i << ' ' << j << ' ' << k;
        EXPECT_NEAR(queries_.distance(p), oracle_.distance(p), 1e-14);
      }
    }
  }
}

TEST_F(BoxQueries, TellTheNextDoubleFromTheBoundary) {
  const Vec3 middle = 0.5 * (oracle_.lower + oracle_.upper);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 p = middle;
    for (const double wall : {oracle_.lower[axis], oracle_.upper[axis]}) {
      p[axis] = wall;
      EXPECT_EQ(queries_.side_of(p), Side::On);
      p[axis] = std::nextafter(wall, 2.0);
      EXPECT_EQ(queries_.side_of(p), oracle_.side_of(p));
      p[axis] = std::nextafter(wall, -2.0);
      EXPECT_EQ(queries_.side_of(p), oracle_.side_of(p));
    }
  }
}

TEST_F(BoxQueries, AgreeOnRandomPoints) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
    EXPECT_EQ(queries_.side_of(p), oracle_.side_of(p));
    EXPECT_NEAR(queries_.distance(p), oracle_.distance(p), 1e-14);
  }
}

TEST_F(BoxQueries, AnswerFarAway) {
  EXPECT_EQ(queries_.side_of({1e300, 0, 0}), Side::Out);
  EXPECT_EQ(queries_.side_of({0, 0, -1e300}), Side::Out);
  EXPECT_NEAR(queries_.distance({1e6, 0, 0}) / (1e6 - oracle_.upper.x), 1, 1e-14);
}

TEST(SolidQueries, KnowCavitiesAndWhatIsInThem) {
  const Solid solid =
      import_it(together(box({0, 0, 0}, {8, 8, 8}),
                         together(reversed(box({1, 1, 1}, {7, 7, 7})), box({2, 2, 2}, {6, 6, 6}))));
  const SolidQueries queries(solid);
  const double scale = solid.universe.scale();
  const auto at = [&](double x, double y, double z) { return solid.universe.to_grid({x, y, z}); };
  EXPECT_EQ(queries.side_of(at(4, 4, 4)), Side::In);
  EXPECT_EQ(queries.side_of(at(4, 4, 1.5)), Side::Out);
  EXPECT_EQ(queries.side_of(at(4, 4, 0.5)), Side::In);
  EXPECT_EQ(queries.side_of(at(4, 4, -0.5)), Side::Out);
  EXPECT_EQ(queries.side_of(at(4, 4, 1)), Side::On);
  EXPECT_NEAR(queries.distance(at(4, 4, 4)) * scale, 2, 1e-13);
  EXPECT_NEAR(queries.distance(at(4, 4, 1.25)) * scale, 0.25, 1e-13);
}

// A sphere's triangulation between its latitudes and longitudes.
PolygonSoup sphere(int rings) {
  std::vector<glm::dvec3> points = {{0, 0, 1}};
  std::vector<Face> faces;
  const auto around = static_cast<std::uint32_t>(2 * rings);
  for (int ring = 1; ring < rings; ++ring) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double latitude = M_PI * ring / rings, longitude = 2 * M_PI * i / around;
      points.emplace_back(std::sin(latitude) * std::cos(longitude),
                          std::sin(latitude) * std::sin(longitude), std::cos(latitude));
    }
  }
  const auto bottom = static_cast<std::uint32_t>(points.size());
  points.emplace_back(0, 0, -1);
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t j = (i + 1) % around;
    faces.push_back({0, 1 + i, 1 + j});
    faces.push_back({bottom, bottom - around + j, bottom - around + i});
    for (std::uint32_t ring = 1; ring + 1 < static_cast<std::uint32_t>(rings); ++ring) {
      const std::uint32_t first = 1 + (ring - 1) * around;
      faces.push_back({first + i, first + around + i, first + around + j});
      faces.push_back({first + i, first + around + j, first + j});
    }
  }
  return make_soup(points, faces);
}

TEST(SolidQueries, AgreeWithASphereUpToItsTriangulation) {
  constexpr int kRings = 64;
  const Solid solid = import_it(sphere(kRings));
  expect_sound(solid);
  const SolidQueries queries(solid);
  const double scale = solid.universe.scale();
  // Triangles lie within this distance inside the sphere.
  const double depth = 1 - std::pow(std::cos(M_PI / kRings / 2), 2) + 1e-3;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
    const double height = glm::length(p) - 1;
    const Vec3 q = solid.universe.to_universe(p);
    EXPECT_NEAR(queries.distance(q) * scale, std::abs(height), depth);
    if (height > 0 || height < -depth) {
      EXPECT_EQ(queries.side_of(q), height > 0 ? Side::Out : Side::In);
    }
  }
}

TEST(SolidQueries, FindEveryVertexOnTheBoundary) {
  const Solid solid = import_it(sphere(16));
  const SolidQueries queries(solid);
  for (const Vec3 v : solid.vertices) {
    EXPECT_EQ(queries.side_of(v), Side::On);
    EXPECT_EQ(queries.distance(v), 0);
  }
}

TEST(SolidQueries, NearestTriangleIsTheNearestOfAll) {
  const Solid solid = import_it(sphere(12));
  const SolidQueries queries(solid);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
    double nearest = std::numeric_limits<double>::infinity();
    for (const SolidTriangle& t : solid.triangles) {
      nearest = std::min(nearest,
                         MeasuredTriangle(solid.vertices[t.vertex[0]], solid.vertices[t.vertex[1]],
                                          solid.vertices[t.vertex[2]])
                             .squared_distance(p));
    }
    const double distance = std::sqrt(nearest);
    EXPECT_EQ(queries.distance(p), distance);
    EXPECT_EQ(queries.distance_beyond(0.9 * distance, p), distance);
    EXPECT_LE(queries.distance_beyond(1.5 * distance, p), 1.5 * distance);
    const auto [near, triangle] = queries.nearest(p, 1.5 * distance);
    EXPECT_EQ(queries.distance_to(triangle, p), near);
  }
}

TEST(MeasuredTriangle, MeasuresToFaceEdgesAndCorners) {
  const MeasuredTriangle triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_DOUBLE_EQ(triangle.squared_distance({0.25, 0.25, 0.5}), 0.25);
  EXPECT_DOUBLE_EQ(triangle.squared_distance({0.5, -0.5, 0}), 0.25);
  EXPECT_DOUBLE_EQ(triangle.squared_distance({1, 1, 0}), 0.5);
  EXPECT_DOUBLE_EQ(triangle.squared_distance({-0.5, -0.5, 0.5}), 0.75);
  EXPECT_DOUBLE_EQ(triangle.squared_distance({2, -1, 0}), 2);
}

TEST(MeasuredTriangle, MeasuresSlivers) {
  // All but a segment along x, one grid step high: the distance is that of the segment.
  const MeasuredTriangle sliver({-0.5, 0, 0}, {0.5, 0, 0}, {0.25, 0x1p-52, 0});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
    const Vec3 nearest{std::clamp(p.x, -0.5, 0.5), 0, 0};
    EXPECT_NEAR(std::sqrt(sliver.squared_distance(p)), glm::distance(p, nearest), 1e-15);
  }
}

TEST(MeasuredTriangle, MeasuresFromFarBeyondTheTipOfANeedle) {
  // Any direction, a few grid steps high at the far end: beyond the tip, all that tells the point
  // from one over the needle is below the rounding of doubles.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-0.5, 0.5);
  std::uniform_int_distribution<int> steps(-3, 3);
  const auto on_grid = [](double x) { return std::ldexp(std::nearbyint(std::ldexp(x, 52)), -52); };
  const auto point = [&] {
    return Vec3{on_grid(coordinate(random)), on_grid(coordinate(random)),
                on_grid(coordinate(random))};
  };
  int measured = 0;
  for (int i = 0; i < 200000; ++i) {
    const Vec3 tip = point();
    const Vec3 end = point();
    const Vec3 height = 0x1p-52 * Vec3{steps(random), steps(random), steps(random)};
    if (glm::cross(height, end - tip) == Vec3{0.0}) continue;
    const MeasuredTriangle needle(tip, end, end + height);
    const Vec3 p = tip - (coordinate(random) + 0.5) * (end - tip);
    ASSERT_NEAR(std::sqrt(needle.squared_distance(p)), glm::distance(p, tip), 0x1p-46);
    ++measured;
  }
  EXPECT_GT(measured, 190000);
}

TEST(BoxTree, FindsThePairsThatComparingAllFinds) {
  std::mt19937 random(4);
  std::uniform_int_distribution<int> corner(0, 20), side(0, 3);  // many boxes just touch
  std::vector<Box> boxes;
  for (int i = 0; i < 300; ++i) {
    const Vec3 lower{corner(random), corner(random), corner(random)};
    boxes.push_back({lower, lower + Vec3{side(random), side(random), side(random)}});
  }
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  Pairs expected, found;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      bool overlaps = true;
      for (int k = 0; k < 3; ++k) {
        overlaps = overlaps && boxes[i].lower[k] <= boxes[j].upper[k] &&
                   boxes[j].lower[k] <= boxes[i].upper[k];
      }
      if (overlaps) expected.emplace_back(i, j);
    }
  }
  BoxTree(boxes).visit_overlapping_pairs([&](std::uint32_t i, std::uint32_t j) {
    found.emplace_back(std::min(i, j), std::max(i, j));
  });
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
  EXPECT_FALSE(expected.empty());
}

TEST(BoxTree, MayBeEmpty) {
  const BoxTree tree{std::vector<Box>{}};
  tree.visit_overlapping_pairs([](std::uint32_t, std::uint32_t) { ADD_FAILURE(); });
  EXPECT_EQ(tree.smallest_squared_distance({0, 0, 0}, [](std::uint32_t) { return 0.0; }),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace spoctree
