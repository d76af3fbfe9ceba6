#include "client/lines/outline.hpp"

#include <gtest/gtest.h>

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

std::vector<Vec2> outline_of_cell(Vec3 toward_viewer) {
  const std::vector<Plane> table;
  const PlaneSet planes(table, 1.0);
  const std::uint32_t lower[3] = {0, 0, 0};
  const Polyhedron cell = make_cell(lower, 1u << (kMaxDepth - 1), planes);  // of side 1
  const Camera camera(toward_viewer);
  OutlineFinder finder(planes, 0, camera, 1e-10);
  std::vector<Vec2> outline;
  finder.find(cell, outline);
  return outline;
}

TEST(Outline, OfACubeIsAHexagonARectangleOrASquare) {
  // A unit cube's shadow across a unit vector has the area |x| + |y| + |z|.
  const std::vector<Vec2> general = outline_of_cell({1, 2, -2});
  EXPECT_EQ(general.size(), 6u);
  EXPECT_NEAR(area(general), 5.0 / 3, 1e-12);
  const std::vector<Vec2> along_a_face = outline_of_cell({3, 0, 4});
  // Two of the rectangle's sides have the end of an edge in their middle.
  EXPECT_EQ(along_a_face.size(), 6u);
  EXPECT_NEAR(area(along_a_face), 1.4, 1e-12);
  const std::vector<Vec2> square_on = outline_of_cell({0, 0, -1});
  EXPECT_EQ(square_on.size(), 4u);
  EXPECT_NEAR(area(square_on), 1, 1e-12);
}

TEST(Straighten, LeavesOutDoubleCornersAndThoseBesideShortEdgesOnly) {
  std::vector<Vec2> polygon = {{0, 0}, {0.5, 0}, {1, 0}, {1, 1e-11}, {1, 1}, {1 - 1e-8, 1 + 1e-16},
                               {0, 1}};
  straighten(polygon, 1e-10);
  // The corner halfway along the lower edge is between long edges: rounding does not turn them.
  const std::vector<Vec2> expected = {{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(polygon, expected);
}

TEST(Straighten, LeavesNothingOfWhatHasNoArea) {
  std::vector<Vec2> polygon = {{0, 0}, {1e-11, 0}, {0, 1e-11}};
  straighten(polygon, 1e-10);
  EXPECT_TRUE(polygon.empty());
  polygon = {};
  straighten(polygon, 1e-10);
  EXPECT_TRUE(polygon.empty());
}

TEST(Straighten, GoesRoundTheStart) {
  std::vector<Vec2> polygon = {{1e-8, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
  straighten(polygon, 1e-10);
  EXPECT_EQ(polygon.size(), 4u);
  EXPECT_NEAR(area(polygon), 1, 1e-7);
}

}  // namespace
}  // namespace spoctree
