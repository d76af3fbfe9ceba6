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

// A prism of height 1 over an area whose border is given as one walk, with bridges to its holes,
// and as the loops that it consists of, each with the area on its left.
PolygonSoup prism_of_walk(const Polygon& points, const Face& walk, const std::vector<Face>& loops) {
  PolygonSoup soup;
  const auto add = [&](const Face& face) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  };
  const auto count = static_cast<std::uint32_t>(points.size());
  for (const double z : {0.0, 1.0}) {
    for (const glm::dvec2& p : points) soup.points.emplace_back(p.x, p.y, z);
  }
  add(Face(walk.rbegin(), walk.rend()));
  Face top = walk;
  for (std::uint32_t& corner : top) corner += count;
  add(top);
  for (const Face& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = loop[i];
      const std::uint32_t b = loop[(i + 1) % loop.size()];
      add({a, b, b + count, a + count});
    }
  }
  return soup;
}

// A frame: 10 x 10 with a hole of 4 x 4 in the middle.
const Polygon kFrame = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {3, 3}, {7, 3}, {7, 7}, {3, 7}};

TEST(Triangulate, CutsAPolygonWithAHoleAtTheEndOfAnyBridgeWhereverItStarts) {
  const std::vector<Face> loops = {{0, 1, 2, 3}, {4, 7, 6, 5}};
  for (std::size_t outer = 0; outer < 4; ++outer) {
    for (std::size_t inner = 0; inner < 4; ++inner) {
      Face walk;
      for (std::size_t i = 0; i <= 4; ++i) walk.push_back(loops[0][(outer + i) % 4]);
      for (std::size_t i = 0; i <= 4; ++i) walk.push_back(loops[1][(inner + i) % 4]);
      for (std::size_t start = 0; start < walk.size(); ++start) {
        std::rotate(walk.begin(), walk.begin() + 1, walk.end());
        const PolygonSoup soup = prism_of_walk(kFrame, walk, loops);
        const Solid solid = import_it(tilted(soup, static_cast<int>(start % 3)));
        expect_sound(solid);
        EXPECT_DOUBLE_EQ(solid.volume, 84);
        EXPECT_EQ(solid.planes.size(), 10u);
        EXPECT_EQ(solid.facet_count(), 10u);
        EXPECT_EQ(solid.triangles.size(), 2u * 8u + 8u * 2u);  // V - E + F = 0: genus 1
        EXPECT_EQ(solid.vertices.size(), 16u);
      }
      EXPECT_DOUBLE_EQ(import_it(reversed(prism_of_walk(kFrame, walk, loops))).volume, 84);
    }
  }
}

TEST(Triangulate, CutsPolygonsWithSeveralHolesAndAnyBridges) {
  // 12 x 6 with a triangle, a square, and in the last case a hole within reach of a hole.
  const Polygon points = {{0, 0}, {12, 0}, {12, 6}, {0, 6},  // 0-3
                          {2, 2}, {4, 2},  {2, 4},           // 4-6, area 2
                          {6, 2}, {8, 2},  {8, 4},  {6, 4},  // 7-10, area 4
                          {5, 3}, {10, 1}, {11, 5}};         // 11-13, on the way
  const std::vector<Face> loops = {{0, 1, 2, 3}, {4, 6, 5}, {7, 10, 9, 8}};
  const auto volume_of = [&](const Face& walk, std::size_t used) {
    Polygon there(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(used));
    const Solid solid = import_it(prism_of_walk(there, walk, loops));
    expect_sound(solid);
    EXPECT_EQ(solid.facet_count(), 2u + 4 + 3 + 4);
    return solid.volume;
  };
  // Both from one corner of the outline; from two; the second from the first.
  EXPECT_DOUBLE_EQ(volume_of({0, 1, 2, 3, 0, 7, 10, 9, 8, 7, 0, 4, 6, 5, 4}, 11), 66);
  EXPECT_DOUBLE_EQ(volume_of({0, 1, 8, 7, 10, 9, 8, 1, 2, 3, 0, 4, 6, 5, 4}, 11), 66);
  EXPECT_DOUBLE_EQ(volume_of({0, 1, 2, 3, 0, 4, 6, 5, 7, 10, 9, 8, 7, 5, 4}, 11), 66);
  // A bridge of two edges, whose middle no other face has: it stays a vertex inside the face.
  EXPECT_DOUBLE_EQ(volume_of({0, 1, 2, 3, 0, 4, 6, 5, 11, 7, 10, 9, 8, 7, 11, 5, 4}, 12), 66);
  // The same bridge there and back for each of two holes.
  EXPECT_DOUBLE_EQ(volume_of({0, 1, 2, 3, 0, 4, 6, 5, 4, 0, 4, 5, 7, 10, 9, 8, 7, 5, 4}, 11), 66);
}

TEST(Triangulate, CutsPolygonsWhoseHolesMeetInACorner) {
  // Two pyramids are dug into the top of a block, with a rim corner in common: one surface there.
  PolygonSoup soup = box({0, 0, 0}, {8, 4, 2});
  const auto top = [&](double x, double y) {
    soup.points.emplace_back(x, y, 2);
    return static_cast<std::uint32_t>(soup.points.size() - 1);
  };
  const std::uint32_t meet = top(4, 2);
  const Face left = {meet, top(1, 1), top(1, 3)};
  const Face right = {meet, top(7, 3), top(7, 1)};
  soup.points.emplace_back(2, 2, 1);
  soup.points.emplace_back(6, 2, 1);
  const auto apex = static_cast<std::uint32_t>(soup.points.size() - 2);
  PolygonSoup dug;
  dug.points = soup.points;
  const auto add = [&](const Face& face) {
    dug.corners.insert(dug.corners.end(), face.begin(), face.end());
    dug.first_corner.push_back(static_cast<std::uint32_t>(dug.corners.size()));
  };
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    Face face(soup.face(f).begin(), soup.face(f).end());
    const bool is_top = std::all_of(face.begin(), face.end(),
                                    [&](std::uint32_t v) { return soup.points[v].z == 2; });
    if (is_top) {
      // Clockwise around both holes, as seen from above.
      face.insert(face.end(), {face[0], meet, left[1], left[2], meet, right[1], right[2], meet});
    }
    add(face);
  }
  for (const auto& [hole, bottom] : {std::pair{left, apex}, std::pair{right, apex + 1}}) {
    for (std::size_t i = 0; i < 3; ++i) add({hole[(i + 1) % 3], hole[i], bottom});
  }
  // 64 without two pyramids of base 3 and height 1.
  const std::string error = import_error(dug);
  ASSERT_EQ(error, "");
  const Solid solid = import_it(dug);
  expect_sound(solid);
  EXPECT_NEAR(solid.volume, 64 - 2, 1e-12);
}

TEST(Triangulate, RefusesWalksThatDoNotBoundOneArea) {
  const std::vector<Face> loops = {{0, 1, 2, 3}, {4, 7, 6, 5}};
  const auto error_of = [&](const Face& walk) {
    return import_error(prism_of_walk(kFrame, walk, loops));
  };
  const auto is_refused = [&](const Face& walk) {
    return error_of(walk).find("2 polygons with edges that cross or touch") != std::string::npos;
  };
  EXPECT_EQ(error_of({0, 1, 2, 3, 0, 4, 7, 6, 5, 4}), "");
  EXPECT_TRUE(is_refused({0, 1, 2, 3, 0, 4, 5, 6, 7, 4}));  // winds twice around the hole
  EXPECT_TRUE(is_refused({0, 1, 2, 3, 0, 1, 2, 3}));        // twice around everything
  EXPECT_TRUE(is_refused({4, 7, 6, 5, 4, 0, 1, 2, 6, 0}));  // crosses itself
  EXPECT_TRUE(is_refused({4, 5, 6, 7, 4, 0, 4, 5, 6, 7}));  // goes out to 0 for nothing
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
