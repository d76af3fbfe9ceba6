// Cracks and T-junctions in hand-made soups: what is merged, what is put into edges, what is said,
// and what is left alone because it is a feature and no fault.
#include "server/solid/repair_borders.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "server/mesh/merge_equal_points.hpp"
#include "server/solid/repair.hpp"
#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;

/// A box of twelve triangles.
PolygonSoup triangle_box(glm::dvec3 size) {
  PolygonSoup soup;
  const PolygonSoup quads = box({0, 0, 0}, size);
  soup.points = quads.points;
  for (std::size_t f = 0; f < quads.face_count(); ++f) {
    const auto face = quads.face(f);
    soup.corners.insert(soup.corners.end(), {face[0], face[1], face[2], face[0], face[2], face[3]});
  }
  for (std::uint32_t i = 1; i <= 12; ++i) soup.first_corner.push_back(3 * i);
  return soup;
}

/// The corner of one face only, moved.
PolygonSoup with_crack(PolygonSoup soup, glm::dvec3 by) {
  soup.points.push_back(soup.points[soup.corners[0]] + by);
  soup.corners[0] = static_cast<std::uint32_t>(soup.points.size() - 1);
  return soup;
}

Solid repaired_solid(const PolygonSoup& soup) {
  Solid solid = import_it(repair(soup).soup);
  expect_sound(solid);
  return solid;
}

bool says(const PolygonSoup& soup, const std::string& what) {
  const Repair repaired = repair(soup);
  return std::any_of(repaired.changes.begin(), repaired.changes.end(),
                     [&](const auto& change) { return change.find(what) != std::string::npos; });
}

TEST(MendBorders, ClosesACrackOfAnyWidthUpToItsBound) {
  const PolygonSoup whole = triangle_box({10, 10, 10});
  const double diagonal = 10 * std::sqrt(3.0);
  for (const double width : {1e-13, 1e-11, 1e-9, 1e-6, 1e-4, 0.9 * kWidestCrack * diagonal}) {
    const PolygonSoup soup = with_crack(whole, {width, 0, 0});
    ASSERT_NE(import_error(soup), "") << width;
    const Solid solid = repaired_solid(soup);
    EXPECT_DOUBLE_EQ(solid.volume, 1000) << width;  // most corners have the exact place
    EXPECT_EQ(solid.vertices.size(), 8u);
    EXPECT_TRUE(says(soup, "merged: 1 corner with others along edges that match, at (")) << width;
  }
}

TEST(MendBorders, LeavesAWiderGapAlone) {
  PolygonSoup soup = with_crack(triangle_box({10, 10, 10}), {0.1, 0, 0});
  EXPECT_EQ(mend_borders(soup, 0).merged.count(), 0u);
  // Unless the file has no finer numbers.
  soup = with_crack(triangle_box({10, 10, 10}), {0.05, 0, 0});
  EXPECT_EQ(mend_borders(soup, 0).merged.count(), 0u);
  EXPECT_EQ(mend_borders(soup, 0.05).merged.count(), 1u);
}

TEST(MendBorders, LeavesAThinPlateWithAnOpenSideThick) {
  // All its open edges match across the missing wall, but the faces lie on each other.
  for (const double thickness : {1e-3, 1e-5, 1e-7}) {
    PolygonSoup soup = without_face(box({0, 0, 0}, {10, 10, thickness}), 3);
    EXPECT_EQ(mend_borders(soup, 0).merged.count(), 0u) << thickness;
    EXPECT_NEAR(repaired_solid(soup).volume / (100 * thickness), 1, 1e-6) << thickness;
  }
}

TEST(MendBorders, LeavesClosedPartsAloneHoweverNearTheyAre) {
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const PolygonSoup soup = together(box({0, 0, 0}, {1, 1, 1}), box({1 + gap, 0, 0}, {2, 1, 1}));
    const Repair repaired = repair(soup);
    EXPECT_TRUE(repaired.changes.empty()) << gap;
    EXPECT_EQ(repaired.soup.points, soup.points);
    EXPECT_EQ(repaired.soup.corners, soup.corners);
  }
}

TEST(MendBorders, DoesNotCloseHolesInWholeNumbersByMerging) {
  // Unit cubes, one face missing: with whole numbers as the precision, its corners are as near as
  // that to each other.
  PolygonSoup soup = without_face(box({0, 0, 0}, {1, 1, 1}), 1);
  soup.precision.unit = 1;
  EXPECT_DOUBLE_EQ(repaired_solid(soup).volume, 1);
  EXPECT_FALSE(says(soup, "merged"));
}

TEST(MendBorders, PutsACornerIntoALongerEdge) {
  const PolygonSoup soup = make_soup({{0, 0, 0},
                                      {2, 0, 0},
                                      {2, 3, 0},
                                      {0, 3, 0},
                                      {0, 0, 4},
                                      {2, 0, 4},
                                      {2, 3, 4},
                                      {0, 3, 4},
                                      {1, 0, 0}},
                                     {{3, 2, 1, 0},
                                      {4, 5, 6, 7},
                                      {1, 2, 6, 5},
                                      {2, 3, 7, 6},
                                      {3, 0, 4, 7},
                                      {0, 8, 5, 4},
                                      {8, 1, 5}});
  ASSERT_NE(import_error(soup).find("not closed"), std::string::npos);
  EXPECT_DOUBLE_EQ(repaired_solid(soup).volume, 24);
  EXPECT_TRUE(says(soup, "put: 1 corner into longer edges, at (1, 0, 0)"));
}

TEST(MendBorders, PutsManyCornersIntoOneEdgeSplitDifferentlyOnBothSides) {
  // The edge y = z = 0 of a box, cut into 7 pieces on one side and into 400 on the other; the
  // corners off the edge by less than the precision.
  std::vector<glm::dvec3> points = {{0, 1, 0}, {1, 1, 0}, {0, 0, 1},
                                    {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  std::vector<Face> faces = {{2, 3, 5, 4}, {0, 4, 5, 1}};
  const auto fan = [&](std::uint32_t first, std::uint32_t last, int pieces, bool is_bottom) {
    Face edge;
    for (int i = 0; i <= pieces; ++i) {
      edge.push_back(static_cast<std::uint32_t>(points.size()));
      const double off = i == 0 || i == pieces ? 0 : 1e-6 * (i % 3 - 1);
      points.emplace_back(static_cast<double>(i) / pieces, is_bottom ? 0 : off,
                          is_bottom ? off : 0);
    }
    // Triangles to `first` and one to `last` from the end.
    for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
      faces.push_back(is_bottom ? Face{edge[i + 1], edge[i], first}
                                : Face{edge[i], edge[i + 1], first});
    }
    faces.push_back(is_bottom ? Face{last, edge.back(), first} : Face{edge.back(), last, first});
    return edge;
  };
  const Face bottom = fan(0, 1, 7, true);
  const Face front = fan(2, 3, 400, false);
  faces.push_back({bottom.front(), front.front(), 2, 4, 0});
  faces.back() = {bottom.front(), 2, 4, 0};
  faces.push_back({bottom.back(), 1, 5, 3});
  PolygonSoup soup = make_soup(points, faces);
  merge_equal_points(soup);
  soup.precision.unit = 1e-6;
  EXPECT_NEAR(repaired_solid(soup).volume, 1, 1e-5);
}

TEST(MendBorders, DropsASliverBelowThePrecisionThatIsInTheWay) {
  // A wall whose two halves are joined by a triangle thinner than the last digit, with edges that
  // nothing matches.
  PolygonSoup soup = without_face(box({0, 0, 0}, {4, 4, 4}), 2);
  const auto a = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), {{2, 0, 0}, {2.000001, 0, 2}, {2, 0, 4}});
  // Corners 0, 1, 4 and 5 are those of the front.
  for (const Face& face : {Face{0, a, a + 2, 4}, Face{a, 1, 5, a + 2}, Face{a, a + 1, a + 2}}) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  soup.precision.unit = 2e-6;
  EXPECT_DOUBLE_EQ(repaired_solid(soup).volume, 64);
  EXPECT_TRUE(says(soup, "dropped: 1 triangle thinner than the precision of the file"));
}

TEST(MendBorders, EndsInTimeWhereAllPointsAreInOneHeap) {
  PolygonSoup soup = triangle_box({1, 1, 1});
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const auto at = static_cast<std::uint32_t>(soup.points.size());
    const double x = 1e-9 * (i % 50);
    const double y = 1e-9 * (i / 50);
    soup.points.insert(soup.points.end(), {{x, y, 0.5}, {x + 0.4, y, 0.5}, {x, y + 0.4, 0.7}});
    soup.corners.insert(soup.corners.end(), {at, at + 1, at + 2});
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  EXPECT_EQ(repair(soup).soup.first_corner.back() % 3, 0u);
}

}  // namespace
}  // namespace spoctree
