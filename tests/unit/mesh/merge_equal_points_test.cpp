#include "server/mesh/merge_equal_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "server/mesh/point_table.hpp"
#include "tests/unit/mesh/mesh_test_support.hpp"

namespace spoctree {
namespace {

using namespace mesh_test;

PolygonSoup soup_of(std::vector<glm::dvec3> points,
                    const std::vector<std::vector<std::uint32_t>>& faces) {
  PolygonSoup soup;
  soup.points = std::move(points);
  for (const auto& face : faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

TEST(MergeEqualPoints, SharesVerticesOfFacesThatMeet) {
  PolygonSoup soup = soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                             {{0, 1, 2}, {3, 4, 5}});
  merge_equal_points(soup);
  EXPECT_EQ(soup.points, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(faces_of(soup), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(MergeEqualPoints, RemovesUnusedPoints) {
  PolygonSoup soup =
      soup_of({{9, 9, 9}, {0, 0, 0}, {8, 8, 8}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, {{4, 1, 3}});
  merge_equal_points(soup);
  EXPECT_EQ(soup.points, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(faces_of(soup), (std::vector<std::vector<std::uint32_t>>{{2, 0, 1}}));
}

TEST(MergeEqualPoints, TakesNegativeZeroForZero) {
  PolygonSoup soup =
      soup_of({{-0.0, 0, 0}, {1, -0.0, 0}, {0, 1, 0}, {0, 0, -0.0}}, {{0, 1, 2}, {3, 2, 1}});
  merge_equal_points(soup);
  EXPECT_EQ(soup.points.size(), 3U);
  EXPECT_FALSE(std::signbit(soup.points[0].x));
}

TEST(MergeEqualPoints, IsExact) {
  PolygonSoup soup = soup_of({{1, 0, 0}, {std::nextafter(1.0, 2.0), 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  merge_equal_points(soup);
  EXPECT_EQ(soup.points.size(), 3U);
}

TEST(MergeEqualPoints, ChangesNothingTheSecondTime) {
  PolygonSoup soup = soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                             {{0, 1, 2}, {3, 4, 5}});
  merge_equal_points(soup);
  const PolygonSoup once = soup;
  merge_equal_points(soup);
  EXPECT_EQ(soup.points, once.points);
  EXPECT_EQ(soup.corners, once.corners);
}

TEST(PointTable, AgreesWithAnOrderedMapOnGridsAndRandomPoints) {
  std::mt19937 random(7);
  std::vector<glm::dvec3> points;
  PointTable table(points);
  std::map<std::tuple<double, double, double>, std::uint32_t> expected;
  for (int i = 0; i < 100000; ++i) {
    glm::dvec3 p(random() % 40, random() % 40, random() % 40);
    if (i % 3 == 0) p *= 0.001;
    if (i % 5 == 0) p = -p;
    const auto next = static_cast<std::uint32_t>(expected.size());
    const auto number = expected.try_emplace({p.x, p.y, p.z}, next).first->second;
    ASSERT_EQ(table.find_or_add(p), number);
  }
  EXPECT_EQ(points.size(), expected.size());
}

}  // namespace
}  // namespace spoctree
