// What import_solid refuses, and in which words: what is wrong, how often, and where first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;

const glm::dvec3 kZero{0, 0, 0};
const glm::dvec3 kOne{1, 1, 1};

// The corner of a cube that is cut off by the plane x + y + z = 4; faces outwards.
PolygonSoup tetrahedron() {
  return make_soup({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}},
                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
}

PolygonSoup moved(PolygonSoup soup, glm::dvec3 by) {
  for (glm::dvec3& p : soup.points) p += by;
  return soup;
}

TEST(JudgeSolid, RefusesAnEmptySoup) {
  EXPECT_EQ(import_error(PolygonSoup{}), "it: empty: no faces");
}

TEST(JudgeSolid, RefusesPointsWithoutFaces) {
  EXPECT_EQ(import_error(make_soup({kZero, kOne}, {})), "it: empty: no faces");
}

TEST(JudgeSolid, RefusesCoordinatesThatAreNotFinite) {
  PolygonSoup soup = tetrahedron();
  soup.points[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(import_error(soup), "it: a coordinate is not finite, at point (0, nan, 0)");
  soup.points[2].y = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(import_error(soup), "it: a coordinate is not finite, at point (0, -inf, 0)");
}

TEST(JudgeSolid, RefusesExtentsThatWouldOverflow) {
  PolygonSoup soup = tetrahedron();
  for (glm::dvec3& p : soup.points) p *= 0x1p1000;
  EXPECT_NE(import_error(soup).find("its extent is"), std::string::npos);
  soup = tetrahedron();
  for (glm::dvec3& p : soup.points) p = (p - 2.0) * 0x1p1022;  // the extent itself overflows
  EXPECT_NE(import_error(soup).find("its extent is inf"), std::string::npos);
  soup = tetrahedron();
  for (glm::dvec3& p : soup.points) p *= 0x1p-1070;
  EXPECT_NE(import_error(soup).find("its extent is"), std::string::npos);
}

TEST(JudgeSolid, RefusesASinglePoint) {
  EXPECT_NE(import_error(make_soup({kOne}, {{0, 0, 0}})).find("its extent is 0"),
            std::string::npos);
}

TEST(JudgeSolid, MergesPointsThatTheGridCannotTellApart) {
  // The corner (0, 0, 0) in three ways.
  PolygonSoup soup = tetrahedron();
  soup.points.push_back({1e-17, 0, 0});
  soup.points.push_back({0, 1e-18, 0});
  const auto first = std::find(soup.corners.begin(), soup.corners.end(), 0u);
  *first = 4;
  *std::find(first, soup.corners.end(), 0u) = 5;
  const Solid solid = import_it(soup);
  expect_sound(solid);
  EXPECT_EQ(solid.vertices.size(), 4u);
  EXPECT_EQ(solid.report.merged_points, 2u);
  ASSERT_EQ(solid.report.settled.size(), 1u);
  EXPECT_EQ(solid.report.settled[0].find("merged: 2 points with others that are nearer than 2^-52"),
            0u)
      << solid.report.settled[0];
}

TEST(JudgeSolid, CountsFacesWithoutArea) {
  PolygonSoup soup =
      make_soup({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 0, 0}, {3, 0, 0}},
                {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {4, 5, 1}, {0, 4, 5, 1}});
  EXPECT_EQ(import_error(soup),
            "it: degenerate: 2 faces without area, at (1, 0, 0)–(3, 0, 0)–(4, 0, 0) and "
            "(0, 0, 0)–(1, 0, 0)–(3, 0, 0)");
}

TEST(JudgeSolid, FindsAFaceWithoutAreaThatRepeatsAPoint) {
  PolygonSoup soup = tetrahedron();
  soup.corners.insert(soup.corners.end(), {3, 3, 1});
  soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  EXPECT_EQ(import_error(soup),
            "it: degenerate: 1 face without area, at (0, 0, 4)–(0, 0, 4)–(4, 0, 0)");
}

TEST(JudgeSolid, AcceptsATriangleThatIsAllButDegenerate) {
  // The corner (2, 2, 0) of a tetrahedron's edge pulled out by one part in 10^13.
  const double out = 2 + 1e-13;
  const Solid solid =
      import_it(make_soup({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {out, out, 0}},
                          {{0, 2, 1}, {2, 4, 1}, {0, 1, 3}, {1, 4, 3}, {4, 2, 3}, {0, 3, 2}}));
  expect_sound(solid);
  EXPECT_NEAR(solid.volume, 64.0 / 6, 1e-11);
}

TEST(JudgeSolid, DropsATriangleThatVanishesOnTheGrid) {
  // The edge (0, 0, 0)-(4, 0, 0) of one face stands (2, h, 0) off the same edge of the other, and a
  // triangle closes the gap. It has an area in the file, but none on the grid.
  const Solid solid =
      import_it(make_soup({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {2, 1e-17, 0}},
                          {{0, 2, 4}, {4, 2, 1}, {0, 4, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}));
  expect_sound(solid);
  EXPECT_NEAR(solid.volume, 64.0 / 6, 1e-14);
  ASSERT_EQ(solid.report.settled.size(), 1u);
  EXPECT_EQ(solid.report.settled[0],
            "dropped: 1 triangle thinner than 2^-52 of the extent, at (0, 0, 0)–(2, 1e-17, 0)–"
            "(4, 0, 0)");
}

TEST(JudgeSolid, CountsBorderEdges) {
  EXPECT_EQ(import_error(without_face(tetrahedron(), 3)),
            "it: not closed: 3 border edges, at (0, 0, 0)–(0, 4, 0), (0, 0, 4)–(0, 0, 0) and "
            "(0, 4, 0)–(0, 0, 4)");
  EXPECT_EQ(import_error(make_soup({kZero, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})),
            "it: not closed: 3 border edges, at (0, 0, 0)–(1, 0, 0), (1, 0, 0)–(0, 1, 0) and "
            "(0, 1, 0)–(0, 0, 0)");
}

TEST(JudgeSolid, CountsBorderEdgesOfAPolygonOnce) {
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NE(import_error(without_face(box(kZero, kOne), i)).find("not closed: 4 border edges"),
              std::string::npos);
  }
}

TEST(JudgeSolid, SaysEdgeWhereThereIsOneOnly) {
  // Two closed fans around one edge more than there should be: two tetrahedra share an edge.
  const PolygonSoup soup = make_soup(
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0, -4, 0}, {0, 0, -4}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {0, 5, 4}});
  EXPECT_EQ(import_error(soup),
            "it: not a manifold: closed parts touch, or a part itself: 1 edge with more than two "
            "faces, at (4, 0, 0)–(0, 0, 0)");
}

TEST(JudgeSolid, FindsAFaceThatIsThereTwice) {
  PolygonSoup soup = tetrahedron();
  soup.corners.insert(soup.corners.end(), {1, 2, 3});
  soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  EXPECT_EQ(import_error(soup),
            "it: not a manifold: 3 edges with more than two faces, at (0, 4, 0)–(4, 0, 0), "
            "(4, 0, 0)–(0, 0, 4) and (0, 4, 0)–(0, 0, 4)");
}

TEST(JudgeSolid, FindsAFlippedFace) {
  const PolygonSoup soup = make_soup({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}},
                                     {{0, 2, 1}, {0, 1, 3}, {1, 3, 2}, {0, 3, 2}});
  EXPECT_EQ(import_error(soup),
            "it: not consistently oriented: 3 edges whose two faces disagree, at (0, 4, 0)–"
            "(4, 0, 0), (4, 0, 0)–(0, 0, 4) and (0, 0, 4)–(0, 4, 0)");
}

TEST(JudgeSolid, FindsAFlippedPolygon) {
  PolygonSoup soup = box(kZero, kOne);
  std::reverse(soup.corners.begin() + 8, soup.corners.begin() + 12);
  EXPECT_NE(import_error(soup).find("not consistently oriented: 4 edges"), std::string::npos);
}

TEST(JudgeSolid, FindsAVertexWithTwoFans) {
  const PolygonSoup soup = make_soup(
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-4, 0, 0}, {0, -4, 0}, {0, 0, -4}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {0, 5, 6}});
  EXPECT_EQ(
      import_error(soup),
      "it: not a manifold: closed parts touch, or a part itself: the faces around 1 vertex form "
      "more than one fan, at "
      "(0, 0, 0)");
}

TEST(JudgeSolid, CountsTheFacesThatASpikePierces) {
  // The three sides of a small tetrahedron stick through one face of a large one.
  const PolygonSoup spike = make_soup({{1, 1, 1}, {2, 1, -1}, {1, 2, -1}, {0.5, 0.5, -1}},
                                      {{1, 3, 2}, {0, 1, 2}, {0, 2, 3}, {0, 3, 1}});
  ASSERT_EQ(import_error(spike), "");
  EXPECT_EQ(import_error(together(tetrahedron(), spike)),
            "it: closed parts touch or overlap: 3 pairs of triangles meet, of 2 of 2 parts, at "
            "(0, 0, 0)–(0, 4, 0)–(4, 0, 0) (part 1) with (1, 1, 1)–(2, 1, -1)–(1, 2, -1) (part 2), "
            "(0, 0, 0)–(0, 4, 0)–(4, 0, 0) (part 1) with "
            "(1, 1, 1)–(1, 2, -1)–(0.5, 0.5, -1) (part 2) and "
            "(0, 0, 0)–(0, 4, 0)–(4, 0, 0) (part 1) with "
            "(1, 1, 1)–(0.5, 0.5, -1)–(2, 1, -1) (part 2)");
}

TEST(JudgeSolid, RefusesBoxesThatOverlapOrTouch) {
  const PolygonSoup a = box(kZero, kOne);
  for (const glm::dvec3 by : {glm::dvec3{0.5, 0.25, 0.125}, glm::dvec3{0.5, 0, 0},
                              glm::dvec3{1, 0.25, 0.25}, glm::dvec3{1, 1, 0.5}}) {
    EXPECT_NE(import_error(together(a, moved(a, by))).find("closed parts touch or overlap: "),
              std::string::npos);
  }
  EXPECT_EQ(import_error(together(a, moved(a, {1 + 0x1p-40, 0.25, 0.25}))), "");
}

TEST(JudgeSolid, RefusesAVertexThatTouchesAFace) {
  // The apex at (1, 1, z) of a pyramid under the face z = 0 of the tetrahedron.
  const auto pyramid = [](double z) {
    return make_soup({{1, 1, z}, {2, 1, -1}, {1, 2, -1}, {0.5, 0.5, -1}},
                     {{1, 3, 2}, {0, 1, 2}, {0, 2, 3}, {0, 3, 1}});
  };
  EXPECT_EQ(import_error(together(tetrahedron(), pyramid(-0x1p-45))), "");
  EXPECT_NE(import_error(together(tetrahedron(), pyramid(0))).find("3 pairs of triangles meet"),
            std::string::npos);
}

TEST(JudgeSolid, RefusesTwoTrianglesBackToBack) {
  const PolygonSoup soup = make_soup({kZero, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  EXPECT_NE(import_error(soup).find("self-intersecting: 1 pair of triangles meet"),
            std::string::npos);
}

TEST(JudgeSolid, RefusesFacesFoldedOntoEachOther) {
  // A tetrahedron without height: two pairs of its triangles overlap on each side of the plane, and
  // across the edges that they share.
  const PolygonSoup soup = make_soup({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}},
                                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  EXPECT_NE(import_error(soup).find("self-intersecting: 3 pairs"), std::string::npos);
}

TEST(JudgeSolid, TurnsASolidWhoseFacesAllPointInwards) {
  for (const PolygonSoup& soup : {tetrahedron(), box(kZero, kOne)}) {
    const Solid right = import_it(soup);
    EXPECT_FALSE(right.report.was_turned);
    const Solid turned = import_it(reversed(soup));
    EXPECT_TRUE(turned.report.was_turned);
    expect_sound(turned);
    EXPECT_DOUBLE_EQ(turned.volume, right.volume);
    EXPECT_EQ(turned.planes.size(), right.planes.size());
  }
}

TEST(JudgeSolid, AcceptsCavitiesAndSolidsInCavities) {
  const PolygonSoup outer = box({0, 0, 0}, {10, 10, 10});
  const PolygonSoup cavity = reversed(box({1, 1, 1}, {9, 9, 9}));
  const PolygonSoup island = box({2, 2, 2}, {8, 8, 8});
  const PolygonSoup bubble = reversed(box({3, 3, 3}, {4, 4, 4}));
  const Solid hollow = import_it(together(outer, cavity));
  expect_sound(hollow);
  EXPECT_NEAR(hollow.volume, 1000 - 512, 1e-9);
  const Solid all = import_it(together(bubble, together(island, together(cavity, outer))));
  expect_sound(all);
  EXPECT_NEAR(all.volume, 1000 - 512 + 216 - 1, 1e-9);
  EXPECT_FALSE(all.report.was_turned);
  const Solid turned =
      import_it(reversed(together(bubble, together(island, together(cavity, outer)))));
  EXPECT_TRUE(turned.report.was_turned);
  EXPECT_NEAR(turned.volume, 1000 - 512 + 216 - 1, 1e-9);
}

TEST(JudgeSolid, RefusesShellsThatNestWrongly) {
  const PolygonSoup outer = box({0, 0, 0}, {10, 10, 10});
  const PolygonSoup inner = box({1, 1, 1}, {9, 9, 9});
  EXPECT_EQ(
      import_error(together(outer, inner))
          .find("it: not consistently oriented: 1 of 2 shells face the wrong way for how they "
                "nest, at (1, 1, 1)–"),
      0u);
  EXPECT_NE(import_error(reversed(together(outer, inner))).find("1 of 2 shells"),
            std::string::npos);
  const PolygonSoup beside = box({11, 0, 0}, {12, 1, 1});
  EXPECT_EQ(import_error(together(outer, beside)), "");
  EXPECT_NE(import_error(together(outer, reversed(beside))).find("1 of 2 shells"),
            std::string::npos);
}

TEST(JudgeSolid, NestsShellsWhoseVerticesAreInLine) {
  // Straight above every corner of the cavity lie corners and edges of the outer shell's facets.
  PolygonSoup outer = box({-1, -1, -1}, {1, 1, 1});
  outer = make_soup(outer.points, {{0, 3, 1},
                                   {0, 2, 3},
                                   {4, 5, 7},
                                   {4, 7, 6},
                                   {0, 1, 5},
                                   {0, 5, 4},
                                   {1, 3, 7},
                                   {1, 7, 5},
                                   {3, 2, 6},
                                   {3, 6, 7},
                                   {2, 0, 4},
                                   {2, 4, 6}});
  const PolygonSoup cavity =
      reversed(make_soup({{0, 0, 0.5}, {0.5, 0.5, 0}, {-0.5, -0.5, 0}, {0.5, -0.5, -0.25}},
                         {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}));
  const Solid hollow = import_it(together(outer, cavity));
  expect_sound(hollow);
  EXPECT_NEAR(hollow.volume, 8 - 0.5 / 6, 1e-14);  // the tetrahedron's determinant is 1/2
  EXPECT_NE(import_error(together(outer, reversed(cavity))).find("1 of 2 shells"),
            std::string::npos);
}

TEST(JudgeSolid, AcceptsASolidFarFromTheOrigin) {
  const glm::dvec3 far{1e12, -1e12, 1e12};
  const Solid solid = import_it(box(far, far + glm::dvec3{1, 2, 3}));
  expect_sound(solid);
  EXPECT_DOUBLE_EQ(solid.volume, 6);
  EXPECT_EQ(solid.planes.size(), 6u);
}

TEST(JudgeSolid, AcceptsTinyAndHugeSolids) {
  for (const double size : {1e-80, 1e80}) {
    const Solid solid = import_it(box(kZero, {size, size, size}));
    expect_sound(solid);
    EXPECT_NEAR(solid.volume / (size * size * size), 1, 1e-12);
  }
}

}  // namespace
}  // namespace spoctree
