// Repair of hand-made soups: what each step changes, what it says, and what it leaves alone.
#include "server/solid/repair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "server/mesh/merge_equal_points.hpp"
#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;

PolygonSoup add_face(PolygonSoup soup, const Face& face) {
  soup.corners.insert(soup.corners.end(), face.begin(), face.end());
  soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  return soup;
}

PolygonSoup flip_face(PolygonSoup soup, std::size_t i) {
  std::reverse(soup.corners.begin() + soup.first_corner[i],
               soup.corners.begin() + soup.first_corner[i + 1]);
  return soup;
}

/// The volume of the repaired soup, which has to be a solid.
double repaired_volume(const PolygonSoup& soup) {
  const Repair repaired = repair(soup);
  EXPECT_TRUE(repaired.refusals.empty());
  const Solid solid = import_it(repaired.soup);
  expect_sound(solid);
  return solid.volume;
}

std::string only_change(const PolygonSoup& soup) {
  const Repair repaired = repair(soup);
  EXPECT_EQ(repaired.changes.size(), 1u);
  return repaired.changes.empty() ? "" : repaired.changes[0];
}

const PolygonSoup kBox = box({0, 0, 0}, {4, 4, 4});

TEST(Repair, LeavesASolidAlone) {
  for (const PolygonSoup& soup : {kBox, together(kBox, reversed(box({1, 1, 1}, {2, 2, 2})))}) {
    const Repair repaired = repair(soup);
    EXPECT_TRUE(repaired.changes.empty());
    EXPECT_TRUE(repaired.refusals.empty());
    EXPECT_EQ(repaired.soup.corners, soup.corners);
  }
}

TEST(Repair, DropsCopiesOfAFace) {
  for (const Face& copy : {Face{4, 5, 7, 6}, Face{7, 6, 4, 5}, Face{5, 4, 6, 7}}) {
    const PolygonSoup soup = add_face(kBox, copy);
    ASSERT_NE(import_error(soup), "");
    EXPECT_DOUBLE_EQ(repaired_volume(soup), 64);
    EXPECT_EQ(only_change(soup).find("dropped: 1 copy of a face, at ("), 0u);
  }
}

TEST(Repair, DropsTheCopyOfAWholeSurface) {
  PolygonSoup soup = kBox;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto face = kBox.face(i);
    soup = add_face(soup, Face(face.begin(), face.end()));
  }
  EXPECT_DOUBLE_EQ(repaired_volume(soup), 64);
  EXPECT_EQ(only_change(soup).find("dropped: 6 copies of a face, first at ("), 0u);
}

TEST(Repair, DropsTheWallBetweenTwoParts) {
  // Two boxes that share the face x = 4, which each of them has.
  const PolygonSoup soup = make_soup({{0, 0, 0},
                                      {4, 0, 0},
                                      {0, 4, 0},
                                      {4, 4, 0},
                                      {0, 0, 4},
                                      {4, 0, 4},
                                      {0, 4, 4},
                                      {4, 4, 4},
                                      {7, 0, 0},
                                      {7, 4, 0},
                                      {7, 0, 4},
                                      {7, 4, 4}},
                                     {{0, 2, 3, 1},
                                      {4, 5, 7, 6},
                                      {0, 1, 5, 4},
                                      {1, 3, 7, 5},
                                      {3, 2, 6, 7},
                                      {2, 0, 4, 6},
                                      {1, 3, 9, 8},
                                      {5, 10, 11, 7},
                                      {1, 8, 10, 5},
                                      {8, 9, 11, 10},
                                      {9, 3, 7, 11},
                                      {3, 1, 5, 7}});
  ASSERT_NE(import_error(soup), "");
  EXPECT_DOUBLE_EQ(repaired_volume(soup), 7 * 4 * 4);
  EXPECT_EQ(only_change(soup),
            "dropped: 1 face between two parts of the solid, at (4, 0, 0)–(4, 4, 0)–(4, 4, 4)");
}

TEST(Repair, PutsTheMiddleOfATriangleWithoutAreaIntoItsNeighbour) {
  // A tetrahedron whose edge (0, 0, 0)-(4, 0, 0) has a point of two of its faces, but not of the
  // others: a triangle without area closes the gap.
  const PolygonSoup soup =
      make_soup({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 0, 0}},
                {{0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {0, 4, 1}, {1, 2, 3}, {0, 3, 2}});
  ASSERT_NE(import_error(soup).find("degenerate"), std::string::npos);
  EXPECT_NEAR(repaired_volume(soup), 64.0 / 6, 1e-12);
  EXPECT_EQ(only_change(soup),
            "dropped: 1 triangle without area, at (0, 0, 0)–(1, 0, 0)–(4, 0, 0)");
}

TEST(Repair, UntanglesTrianglesWithoutAreaThatLieAgainstEachOther) {
  // The same with three points on the edge, as a fan of needles.
  const PolygonSoup soup = make_soup(
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 2, 4},
                                                                                      {4, 2, 5},
                                                                                      {5, 2, 6},
                                                                                      {6, 2, 1},
                                                                                      {0, 1, 3},
                                                                                      {0, 4, 1},
                                                                                      {4, 5, 1},
                                                                                      {5, 6, 1},
                                                                                      {1, 2, 3},
                                                                                      {0, 3, 2}});
  EXPECT_NEAR(repaired_volume(soup), 64.0 / 6, 1e-12);
  EXPECT_EQ(only_change(soup).find("dropped: 3 triangles without area, at ("), 0u);
}

TEST(Repair, TurnsTheFewerFaces) {
  EXPECT_DOUBLE_EQ(repaired_volume(flip_face(kBox, 2)), 64);
  EXPECT_EQ(only_change(flip_face(kBox, 0)),
            "turned: 1 face that disagreed with the faces around, at "
            "(4, 0, 0)–(4, 4, 0)–(0, 4, 0)");
  PolygonSoup soup = kBox;
  for (const std::size_t i : {0u, 1u, 2u, 4u, 5u}) soup = flip_face(soup, i);
  EXPECT_EQ(only_change(soup).find("turned: 1 face "), 0u);
}

TEST(Repair, LeavesAOneSidedSurfaceAlone) {
  // A Möbius strip of five triangles.
  const PolygonSoup soup = make_soup({{0, 0, 0}, {4, 0, 1}, {5, 4, 2}, {1, 6, 1}, {-2, 3, 0}},
                                     {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}});
  const Repair repaired = repair(soup);
  EXPECT_TRUE(repaired.changes.empty());
  EXPECT_NE(import_error(repaired.soup), "");
}

TEST(Repair, FillsAHoleWithItsOwnPoints) {
  for (std::size_t i = 0; i < 6; ++i) {
    const PolygonSoup soup = without_face(kBox, i);
    EXPECT_DOUBLE_EQ(repaired_volume(soup), 64);
    EXPECT_EQ(repair(soup).soup.points, soup.points);
    const std::string change = only_change(soup);
    EXPECT_EQ(change.find("filled: 1 hole with 2 faces, at ("), 0u) << change;
    // A face's diagonal is sqrt(2/3) of the box's.
    EXPECT_NE(change.find("4 edges, is 81.6 % of the diagonal in size, flat"), std::string::npos)
        << change;
  }
}

TEST(Repair, FillsHolesThatTouchInAPoint) {
  // Two triangles of an octahedron that share a corner only.
  const PolygonSoup octahedron = make_soup(
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  const PolygonSoup soup = without_face(without_face(octahedron, 2), 0);
  ASSERT_NE(import_error(soup), "");
  EXPECT_NEAR(repaired_volume(soup), 4.0 / 3, 1e-15);
  EXPECT_EQ(only_change(soup).find("filled: 2 holes with 2 faces"), 0u);
}

// A drum: two rings of n points, the walls between, and a cone below. The top is open, its rim up
// and down by `wave`.
PolygonSoup open_drum(std::uint32_t n, double radius, double wave) {
  std::vector<glm::dvec3> points;
  std::vector<Face> faces;
  for (const double z : {0.0, 1.0}) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                          z + (z > 0 ? wave * std::sin(7 * angle) : 0));
    }
  }
  points.emplace_back(0, 0, -10);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    faces.push_back({i, j, n + j});
    faces.push_back({i, n + j, n + i});
    faces.push_back({j, i, 2 * n});
  }
  return make_soup(points, faces);
}

TEST(Repair, ClosesALargeFlatHoleWithOnePolygon) {
  constexpr std::uint32_t kSides = 3000;
  const PolygonSoup soup = open_drum(kSides, 2, 0);
  EXPECT_NE(only_change(soup).find("1 hole with 1 face, at"), std::string::npos);
  // A regular polygon's area times the drum's height and a third of the cone's.
  const double area = kSides * 2 * std::sin(2 * std::numbers::pi / kSides);
  EXPECT_NEAR(repaired_volume(soup), area * (1 + 10.0 / 3), 1e-9);
}

TEST(Repair, FillsAnUnevenHoleOfManyEdges) {
  const PolygonSoup soup = open_drum(400, 1, 0.2);
  // The patch lies between the lowest and the highest point of the rim.
  EXPECT_NEAR(repaired_volume(soup), std::numbers::pi * (1 + 10.0 / 3), std::numbers::pi * 0.2);
}

// CGAL's filling in the plane of the hole ended in a segmentation fault here.
TEST(Repair, FillsAFlatHoleThatIsAllButALine) {
  for (const bool is_other_way : {false, true}) {
    PolygonSoup soup = make_soup({{0.6000000238418579, -2, 3.200000047683716},
                                  {1.399999976158142, -2, 3.200000047683716},
                                  {0.6000000238418579, -0.8660249710083008, 3.200000047683716},
                                  {1.399999976158142, -2, 13743895552.0},
                                  {0, 0, 0}},
                                 {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
    if (is_other_way) soup = reversed(soup);
    // Seen from the far corner, two of the others are one; that may be mended first.
    EXPECT_FALSE(repair(soup).changes.empty());
  }
}

TEST(Repair, DoesNotGuessTheShapeOfALargeUnevenHole) {
  const Repair repaired = repair(open_drum(400, 8, 2));
  EXPECT_TRUE(repaired.changes.empty());
  ASSERT_EQ(repaired.refusals.size(), 1u);
  EXPECT_EQ(repaired.refusals[0].find("1 hole neither flat nor within 25 % of the diagonal"), 0u)
      << repaired.refusals[0];
}

TEST(Repair, LeavesHolesWithTooManyEdgesOpen) {
  const Repair repaired = repair(open_drum(kMostHoleEdges + 1, 1, 0.2));
  EXPECT_TRUE(repaired.changes.empty());
  ASSERT_EQ(repaired.refusals.size(), 1u);
  EXPECT_EQ(repaired.refusals[0].find("1 hole with too many edges"), 0u);
}

TEST(Repair, DoesNotCloseAFaceWithItself) {
  for (const std::uint32_t corners : {3u, 4u, 1000u}) {
    PolygonSoup soup;
    for (std::uint32_t i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      soup.points.emplace_back(std::cos(angle), std::sin(angle), 0);
      soup.corners.push_back(i);
    }
    soup.first_corner.push_back(corners);
    const Repair repaired = repair(soup);
    EXPECT_TRUE(repaired.changes.empty());
    EXPECT_EQ(repaired.refusals.size(), 1u);
  }
}

TEST(Repair, HandsOnThePointsOfNeedlesThatLieAgainstEachOther) {
  // 300 triangles without area, each against the one before.
  constexpr std::uint32_t kNeedles = 300;
  PolygonSoup soup = make_soup({{0, 0, 0}, {kNeedles + 1, 0, 0}, {0, 5, 0}, {0, 0, 5}},
                               {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  std::uint32_t last = 0;
  for (std::uint32_t i = 1; i <= kNeedles + 1; ++i) {
    const bool is_end = i == kNeedles + 1;
    const std::uint32_t next = is_end ? 1 : static_cast<std::uint32_t>(soup.points.size());
    if (!is_end) soup.points.emplace_back(i, 0, 0);
    soup = add_face(soup, {last, 2, next});
    if (!is_end) soup = add_face(soup, {last, next, 1});
    last = next;
  }
  EXPECT_EQ(only_change(soup).find("dropped: 300 triangles without area, first at ("), 0u);
  EXPECT_NEAR(repaired_volume(soup), (kNeedles + 1) * 25 / 6.0, 1e-9);
}

TEST(Repair, TurnsTheEdgeOfTwoNeedlesThatShareTheirLongestOne) {
  // The edge (0, 0, 0)-(4, 0, 0) has the point 1 in one face and the point 3 in the other; between
  // them are two needles, 0-1-4 and 0-3-4.
  const PolygonSoup soup = make_soup(
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 0, 0}, {3, 0, 0}},
      {{0, 2, 4}, {4, 2, 1}, {0, 4, 1}, {0, 1, 5}, {0, 5, 3}, {5, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  EXPECT_NEAR(repaired_volume(soup), 64.0 / 6, 1e-12);
  EXPECT_EQ(only_change(soup).find("dropped: 2 triangles without area, at ("), 0u);
}

// Thin sticks side by side, askew: the box of each overlaps that of every other.
TEST(JudgeSolid, RefusesMoreTrianglesThanCanBeCompared) {
  std::vector<glm::dvec3> points;
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const double y = 1e-4 * i;
    const std::uint32_t a = 4 * i;
    points.insert(points.end(), {{0, y, 0}, {1, 1 + y, 0}, {0, y + 5e-5, 0}, {0, y, 5e-5}});
    faces.insert(faces.end(),
                 {{a, a + 2, a + 1}, {a, a + 1, a + 3}, {a + 1, a + 2, a + 3}, {a, a + 3, a + 2}});
  }
  EXPECT_NE(
      import_error(make_soup(points, faces)).find("too entangled to be judged: the bounding "),
      std::string::npos);
}

/// The volume of what is left, which may touch itself.
double united_volume(PolygonSoup soup) {
  merge_equal_points(soup);
  const Repair repaired = repair(soup);
  EXPECT_TRUE(repaired.refusals.empty());
  ImportOptions options;
  options.turn_shells = true;
  options.may_touch_itself = true;
  return import_solid(repaired.soup, "it", options).volume;
}

TEST(Unite, MakesOneSolidOfPartsThatOverlap) {
  const PolygonSoup soup = together(kBox, box({2, 2, 2}, {6, 6, 6}));
  EXPECT_NE(import_error(soup).find("closed parts touch or overlap: "), std::string::npos);
  EXPECT_DOUBLE_EQ(repaired_volume(soup), 64 + 64 - 8);
  const Repair repaired = repair(soup);
  ASSERT_EQ(repaired.changes.size(), 2u);
  EXPECT_EQ(repaired.changes[0].find("united: 2 of 2 closed parts, which touched or overlapped"),
            0u);
  EXPECT_EQ(import_it(repaired.soup).planes.size(), 12u);
}

TEST(Unite, MakesOneSolidOfABossOnAPlate) {
  const PolygonSoup soup = together(box({0, 0, 0}, {10, 10, 2}), box({3, 3, 2}, {6, 6, 5}));
  EXPECT_DOUBLE_EQ(repaired_volume(soup), 227);
  EXPECT_EQ(import_it(repair(soup).soup).planes.size(), 11u);
}

TEST(Unite, LetsAPartWithinAnotherVanish) {
  const PolygonSoup soup = together(kBox, box({1, 1, 1}, {3, 3, 3}));
  EXPECT_DOUBLE_EQ(repaired_volume(soup), 64);
  EXPECT_EQ(repair(soup).soup.face_count(), 12u);
}

TEST(Unite, KeepsACavityBesideAnOverlap) {
  const PolygonSoup soup =
      together(together(kBox, reversed(box({1, 1, 1}, {2, 2, 2}))), box({3, 3, 3}, {6, 6, 6}));
  EXPECT_DOUBLE_EQ(repaired_volume(soup), 64 - 1 + 27 - 1);
}

TEST(Unite, TakesAwayWhatFacesInwardsAndOverlaps) {
  const PolygonSoup soup = together(kBox, reversed(box({2, 2, 2}, {6, 6, 6})));
  EXPECT_DOUBLE_EQ(repaired_volume(soup), 64 - 8);
}

TEST(Unite, TurnsWhatFacesInwardsEverywhere) {
  const PolygonSoup soup = reversed(together(kBox, box({2, 2, 2}, {6, 6, 6})));
  EXPECT_DOUBLE_EQ(repaired_volume(soup), 64 + 64 - 8);
  EXPECT_EQ(repair(soup).changes.back(), "turned: all faces pointed inwards");
}

TEST(Unite, KeepsBothPartsThatShareAFaceAndOverlap) {
  EXPECT_DOUBLE_EQ(united_volume(together(kBox, box({0, 0, 0}, {4, 4, 7}))), 112);
}

TEST(Unite, LetsPartsTouchInAnEdgeOrAPoint) {
  EXPECT_DOUBLE_EQ(united_volume(together(kBox, box({4, 4, 0}, {6, 6, 4}))), 64 + 16);
  EXPECT_DOUBLE_EQ(united_volume(together(kBox, box({4, 4, 1}, {6, 6, 2}))), 64 + 4);
  EXPECT_DOUBLE_EQ(united_volume(together(kBox, box({4, 4, 4}, {5, 5, 5}))), 65);
  const PolygonSoup along_an_edge = together(kBox, box({4, 4, 1}, {6, 6, 2}));
  EXPECT_NE(import_error(repair(along_an_edge).soup).find("1 edge with more than two faces"),
            std::string::npos);
}

TEST(Unite, RefusesTheManyPairsOfHostileFiles) {
  PolygonSoup soup = box({0, 0, 0}, {1, 400, 1});
  for (int i = 0; i < 70; ++i) {
    soup = together(soup, box({2.0 * i + 2, 0, 0}, {2.0 * i + 3, 400, 1}));
    soup = together(soup, box({0, 2.0 * i, 0.25}, {400, 2.0 * i + 1, 0.75}));
  }
  const Repair repaired = repair(soup);
  ASSERT_EQ(repaired.refusals.size(), 1u);
  EXPECT_NE(repaired.refusals[0].find("pairs of triangles meet, too many to resolve"),
            std::string::npos);
  EXPECT_EQ(repaired.soup.face_count(), soup.face_count());
}

TEST(TurnShells, TurnsWhatNestsWrongly) {
  const PolygonSoup soup =
      together(together(kBox, box({1, 1, 1}, {3, 3, 3})), reversed(box({5, 0, 0}, {6, 1, 1})));
  ASSERT_NE(import_error(soup).find("2 of 3 shells"), std::string::npos);
  ImportOptions options;
  options.turn_shells = true;
  const Solid solid = import_solid(soup, "it", options);
  expect_sound(solid);
  EXPECT_DOUBLE_EQ(solid.volume, 64 - 8 + 1);
  EXPECT_EQ(solid.report.turned_shells, 2u);
  EXPECT_FALSE(solid.report.was_turned);
}

}  // namespace
}  // namespace spoctree
