// Faces with more than three corners.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;

using Polygon = std::vector<glm::dvec2>;

const Polygon kL = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

// A star with n tips of radius 2 between notches of radius 1; its area is n sin(pi / n) * 2.
Polygon star(int n) {
  Polygon polygon;
  for (int i = 0; i < 2 * n; ++i) {
    const double angle = M_PI * i / n;
    polygon.push_back((i % 2 == 0 ? 2.0 : 1.0) * glm::dvec2{std::cos(angle), std::sin(angle)});
  }
  return polygon;
}

// Moves the soup's axes: x to y, y to z, z to x.
PolygonSoup tilted(PolygonSoup soup, int times) {
  for (glm::dvec3& p : soup.points) {
    for (int i = 0; i < times; ++i) p = {p.z, p.x, p.y};
  }
  return soup;
}

TEST(Triangulate, CutsACubeIntoTwelveTriangles) {
  const Solid solid = import_it(box({0, 0, 0}, {1, 1, 1}));
  expect_sound(solid);
  EXPECT_EQ(solid.triangles.size(), 12u);
  EXPECT_EQ(solid.report.input_faces, 6u);
  EXPECT_EQ(solid.report.triangulated_faces, 6u);
  EXPECT_NEAR(solid.report.largest_unevenness, 0, 1e-15);
  EXPECT_DOUBLE_EQ(solid.volume, 1);
}

TEST(Triangulate, CutsAConcavePolygonWhereverItStarts) {
  for (std::size_t start = 0; start < kL.size(); ++start) {
    Polygon polygon = kL;
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(start),
                polygon.end());
    for (int axis = 0; axis < 3; ++axis) {
      const Solid solid = import_it(tilted(prism(polygon, 1), axis));
      expect_sound(solid);
      EXPECT_DOUBLE_EQ(solid.volume, 3);
      EXPECT_EQ(solid.facet_count(), 8u);
      EXPECT_EQ(solid.planes.size(), 8u);
    }
  }
}

TEST(Triangulate, CutsAConcaveQuadrilateral) {
  // A dart: a triangle of area 4 with a notch of area 2.5.
  Polygon dart = {{0, 0}, {2, 0}, {0.5, 0.5}, {0, 4}};
  for (int start = 0; start < 4; ++start) {
    const Solid solid = import_it(prism(dart, 2));
    expect_sound(solid);
    EXPECT_DOUBLE_EQ(solid.volume, 2 * 1.5);
    std::rotate(dart.begin(), dart.begin() + 1, dart.end());
  }
}

TEST(Triangulate, CutsStars) {
  for (const int tips : {3, 5, 100}) {
    const Solid solid = import_it(prism(star(tips), 1));
    expect_sound(solid);
    EXPECT_NEAR(solid.volume, 2 * tips * std::sin(M_PI / tips), 1e-12);
    EXPECT_EQ(solid.triangles.size(), 2u * (2u * tips - 2u) + 4u * tips);
  }
}

TEST(Triangulate, KeepsCornersInTheMiddleOfAnEdge) {
  // A square with corners also in the middle of its sides.
  const Polygon polygon = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  const Solid solid = import_it(prism(polygon, 1));
  expect_sound(solid);
  EXPECT_DOUBLE_EQ(solid.volume, 4);
  EXPECT_EQ(solid.planes.size(), 6u);
  EXPECT_EQ(solid.facet_count(), 6u);
  EXPECT_EQ(solid.vertices.size(), 16u);
}

TEST(Triangulate, KeepsACornerInTheMiddleOfAQuadrilateralsEdge) {
  Polygon triangle = {{0, 0}, {1, 0}, {2, 0}, {0, 2}};
  for (int start = 0; start < 4; ++start) {
    const Solid solid = import_it(prism(triangle, 1));
    expect_sound(solid);
    EXPECT_DOUBLE_EQ(solid.volume, 2);
    std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
  }
}

TEST(Triangulate, MeasuresUnevenness) {
  // The top's corners lie h above and below its mean plane in turn.
  constexpr double kH = 1.0 / 16;
  PolygonSoup soup = box({0, 0, 0}, {1, 1, 1});
  for (const int corner : {4, 7}) soup.points[static_cast<std::size_t>(corner)].z += kH;
  for (const int corner : {5, 6}) soup.points[static_cast<std::size_t>(corner)].z -= kH;
  const Solid solid = import_it(soup);
  expect_sound(solid);
  const double diagonal = std::sqrt(1 + 1 + (1 + kH) * (1 + kH));
  EXPECT_NEAR(solid.report.largest_unevenness, kH / diagonal, 1e-12);
  EXPECT_EQ(solid.planes.size(), 7u);
  // The top is a ridge or a valley along a diagonal: each half is a prism of mean height
  // 1 + h/3 or 1 - h/3.
  EXPECT_NEAR(std::abs(solid.volume - 1), kH / 3, 1e-12);
}

TEST(Triangulate, RefusesPolygonsThatCrossOrTouchThemselves) {
  const Polygon bow_tie = {{0, 0}, {2, 2}, {2, 0}, {0, 1}};
  EXPECT_EQ(import_error(prism(bow_tie, 1)),
            "it: 2 polygons with edges that cross or touch, at (0, 1, 0)–(2, 0, 0)–(2, 2, 0) "
            "and (0, 0, 1)–(2, 2, 1)–(2, 0, 1)");
  const Polygon crossing = {{0, 0}, {4, 0}, {4, 4}, {1, -1}, {0, 4}};
  EXPECT_NE(import_error(prism(crossing, 1)).find("2 polygons with edges"), std::string::npos);
  // The corner (2, 0) touches the first side.
  const Polygon touching = {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}};
  EXPECT_NE(import_error(prism(touching, 1)).find("2 polygons with edges"), std::string::npos);
}

TEST(Triangulate, GivesTheSameTrianglesEveryTime) {
  const PolygonSoup soup = prism(star(50), 1);
  const Solid a = import_it(soup);
  const Solid b = import_it(soup);
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    EXPECT_TRUE(std::equal(std::begin(a.triangles[i].vertex), std::end(a.triangles[i].vertex),
                           std::begin(b.triangles[i].vertex)));
  }
}

}  // namespace
}  // namespace spoctree
