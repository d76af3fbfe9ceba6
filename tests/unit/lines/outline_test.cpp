#include "client/lines/outline.hpp"

#include <gtest/gtest.h>

#include "tests/support/random.hpp"

namespace spoctree {
namespace {

double area(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 a = polygon[k];
    const Vec2 b = polygon[(k + 1) % polygon.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2;
}

std::vector<Vec2> outline_of_cube(Vec3 toward_viewer) {
  const Camera camera(toward_viewer);
  std::vector<Vec2> points;
  for (unsigned corner = 0; corner < 8; ++corner) {
    points.push_back(camera.project({corner & 1, corner >> 1 & 1, corner >> 2}));
  }
  std::vector<Vec2> outline;
  find_outline(points, outline);
  return outline;
}

TEST(Outline, OfACubeIsAHexagonARectangleOrASquare) {
  // A unit cube's shadow across a unit vector has the area |x| + |y| + |z|.
  const std::vector<Vec2> general = outline_of_cube({1, 2, -2});
  EXPECT_EQ(general.size(), 6u);
  EXPECT_NEAR(area(general), 5.0 / 3, 1e-12);
  const std::vector<Vec2> along_a_face = outline_of_cube({3, 0, 4});
  EXPECT_NEAR(area(along_a_face), 1.4, 1e-12);
  const std::vector<Vec2> square_on = outline_of_cube({0, 0, -1});
  EXPECT_EQ(square_on.size(), 4u);
  EXPECT_NEAR(area(square_on), 1, 1e-12);
}

TEST(Outline, OfPointsOnALineIsNothing) {
  std::vector<Vec2> points{{0, 0}, {1, 1}, {0.5, 0.5}, {2, 2}};
  std::vector<Vec2> outline;
  find_outline(points, outline);
  EXPECT_TRUE(outline.empty());
}

TEST(Outline, HasAllPointsToItsLeft) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec2> points;
    for (std::uint32_t k = 0; k < 3 + random.below(20); ++k) {
      points.push_back({random.between(-1, 1), random.between(-1, 1)});
    }
    std::vector<Vec2> sorted = points;
    std::vector<Vec2> outline;
    find_outline(sorted, outline);
    ASSERT_GE(outline.size(), 3u);
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vec2 along = outline[(k + 1) % outline.size()] - outline[k];
      for (const Vec2 point : points) {
        const Vec2 off = point - outline[k];
        EXPECT_GE(along.x * off.y - along.y * off.x, -1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace spoctree
