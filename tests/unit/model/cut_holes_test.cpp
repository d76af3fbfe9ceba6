// Faces with holes become simple polygons that cover the same area on the same points.

#include "tools/model/cut_holes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "tests/unit/model/mesh_measures.hpp"

namespace spoctree::model {
namespace {

struct Face {
  std::vector<glm::dvec3> points;
  Loop outer;
  std::vector<Loop> holes;

  Loop append(const std::vector<glm::dvec2>& corners, bool clockwise) {
    Loop loop;
    for (const glm::dvec2& corner : corners) {
      loop.push_back(static_cast<std::uint32_t>(points.size()));
      points.emplace_back(corner.x, corner.y, 0);
    }
    if (clockwise) std::reverse(loop.begin(), loop.end());
    return loop;
  }
};

std::vector<glm::dvec2> square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

Face face_with_holes(int columns, int rows) {
  Face face;
  face.outer = face.append(
      {{0, 0}, {3.0 * columns, 0}, {3.0 * columns, 3.0 * rows}, {0, 3.0 * rows}}, false);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      face.holes.push_back(face.append(square(1 + 3 * column, 1 + 3 * row, 1), true));
  return face;
}

/// The area of the pieces, all of which have to be simple and to look the same way as the face.
double area_of_pieces(const Face& face, const std::vector<Loop>& pieces) {
  const PolygonMesh mesh{face.points, pieces};
  const glm::dvec3 up = glm::normalize(vector_area(mesh, face.outer));
  double area = 0;
  for (const Loop& piece : pieces) {
    EXPECT_TRUE(is_simple(mesh, piece));
    const double part = glm::dot(vector_area(mesh, piece), up);
    EXPECT_GT(part, 0);
    area += part;
  }
  return area;
}

TEST(CutHoles, LeavesAFaceWithoutHolesAsItIs) {
  Face face;
  face.outer = face.append(square(0, 0, 2), false);
  EXPECT_EQ(cut_holes(face.points, face.outer, {}), std::vector<Loop>{face.outer});
}

TEST(CutHoles, MakesOnePieceMoreThanThereAreHoles) {
  const Face face = face_with_holes(4, 3);
  const auto pieces = cut_holes(face.points, face.outer, face.holes);
  EXPECT_EQ(pieces.size(), 13U);
  EXPECT_DOUBLE_EQ(area_of_pieces(face, pieces), 12 * 8);  // 9 - 1 around every hole
}

TEST(CutHoles, DoesSoFromEverySide) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      Face face = face_with_holes(2, 2);
      for (glm::dvec3& point : face.points) {
        glm::dvec3 turned{0.0};
        turned[(axis + 1) % 3] = sign * point.x;
        turned[(axis + 2) % 3] = point.y;
        turned[axis] = 7;
        point = turned;
      }
      const auto pieces = cut_holes(face.points, face.outer, face.holes);
      EXPECT_EQ(pieces.size(), 5U);
      EXPECT_DOUBLE_EQ(area_of_pieces(face, pieces), 4 * 8);
    }
}

TEST(CutHoles, ReachesAHoleInsideTheBendOfAnother) {
  Face face;
  face.outer = face.append(square(0, 0, 20), false);
  // A C that hides the small square but for its mouth on the right.
  face.holes.push_back(face.append({{4, 4},
                                    {16, 4},
                                    {16, 9},
                                    {15, 9},
                                    {15, 5},
                                    {5, 5},
                                    {5, 15},
                                    {15, 15},
                                    {15, 11},
                                    {16, 11},
                                    {16, 16},
                                    {4, 16}},
                                   true));
  face.holes.push_back(face.append(square(9, 9, 2), true));
  const auto pieces = cut_holes(face.points, face.outer, face.holes);
  EXPECT_EQ(pieces.size(), 3U);
  const double c = 12 * 12 - 10 * 10 - 1 * 2;  // its mouth is 1 deep and 2 high
  EXPECT_DOUBLE_EQ(area_of_pieces(face, pieces), 400 - c - 4);
}

TEST(CutHoles, KeepsTheBoundaryAndAddsOnlyCutsThatTwoPiecesShare) {
  const Face face = face_with_holes(3, 2);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> left;
  for (const Loop& piece : cut_holes(face.points, face.outer, face.holes))
    for (std::size_t i = 0; i < piece.size(); ++i)
      left.emplace_back(piece[i], piece[(i + 1) % piece.size()]);
  const auto take = [&](std::uint32_t a, std::uint32_t b) {
    const auto found = std::find(left.begin(), left.end(), std::pair{a, b});
    ASSERT_NE(found, left.end());
    left.erase(found);
  };
  std::vector<Loop> loops = face.holes;
  loops.push_back(face.outer);
  for (const Loop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) take(loop[i], loop[(i + 1) % loop.size()]);
  ASSERT_EQ(left.size(), 2U * 2 * 6);  // two cuts a hole, two sides a cut
  while (!left.empty()) {
    const auto [a, b] = left.back();
    left.pop_back();
    take(b, a);
  }
}

}  // namespace
}  // namespace spoctree::model
