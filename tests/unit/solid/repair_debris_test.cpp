// Scraps and flaps beside and on solids: what is dropped, and what is not.
#include "server/solid/repair_debris.hpp"

#include <gtest/gtest.h>

#include "server/solid/repair.hpp"
#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;

const PolygonSoup kBox = box({0, 0, 0}, {4, 4, 4});

PolygonSoup with_faces(PolygonSoup soup, const std::vector<glm::dvec3>& points,
                       std::vector<Face> faces) {
  soup.points.insert(soup.points.end(), points.begin(), points.end());
  for (const Face& face : faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

double volume_of(const Repair& repaired) {
  const Solid solid = import_it(repaired.soup);
  expect_sound(solid);
  return solid.volume;
}

TEST(Debris, ALoneTriangleGoes) {
  const Repair repaired =
      repair(with_faces(kBox, {{20, 20, 20}, {21, 20, 20}, {20, 21, 20}}, {{8, 9, 10}}));
  EXPECT_DOUBLE_EQ(volume_of(repaired), 64);
  ASSERT_EQ(repaired.changes.size(), 1u);
  EXPECT_EQ(repaired.changes[0],
            "dropped: 1 piece of surface that bounds nothing (1 face), at (20, 20, 20)–"
            "(21, 20, 20)–(20, 21, 20)");
  // Its corners do not count for the extent any more.
  EXPECT_EQ(repaired.soup.points.size(), 8u);
}

TEST(Debris, FlapsOfTwoTrianglesGoAndAreNoSolids) {
  const std::vector<glm::dvec3> corners = {{6, 0, 0}, {8, 0, 0}, {7, 1, 0}, {7, 0, 1}};
  // Open, at a right angle; the same, and both back to back; closed, but flat.
  for (const auto& faces :
       {std::vector<Face>{{8, 9, 10}, {9, 8, 11}}, std::vector<Face>{{8, 9, 10}, {9, 8, 10}}}) {
    const Repair repaired = repair(with_faces(kBox, corners, faces));
    EXPECT_DOUBLE_EQ(volume_of(repaired), 64);
  }
  const Repair flat = repair(with_faces(kBox, {{6, 0, 0}, {8, 0, 0}, {8, 1, 0}, {6, 1, 0}},
                                        {{8, 9, 10}, {8, 10, 11}, {9, 8, 11}, {9, 11, 10}}));
  EXPECT_DOUBLE_EQ(volume_of(flat), 64);
}

TEST(Debris, AFlapAloneIsNoSolid) {
  const PolygonSoup flap =
      make_soup({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}}, {{0, 1, 2}, {1, 0, 3}});
  EXPECT_TRUE(repair(flap).changes.empty());
  EXPECT_NE(import_error(repair(flap).soup).find("not closed"), std::string::npos);
}

TEST(Debris, AFlatGroundGoesHoweverLarge) {
  const Repair repaired = repair(with_faces(
      kBox, {{-99, -99, -1}, {99, -99, -1}, {99, 99, -1}, {-99, 99, -1}}, {{8, 9, 10, 11}}));
  EXPECT_DOUBLE_EQ(volume_of(repaired), 64);
}

TEST(Debris, ACurvedStripGoes) {
  std::vector<glm::dvec3> points;
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i <= 6; ++i) {
    const double angle = 0.2 * i;
    points.emplace_back(10 + std::cos(angle), std::sin(angle), 0);
    points.emplace_back(10 + std::cos(angle), std::sin(angle), 1);
    if (i > 0) faces.push_back({6 + 2 * i, 8 + 2 * i, 9 + 2 * i, 7 + 2 * i});
  }
  EXPECT_DOUBLE_EQ(volume_of(repair(with_faces(kBox, points, faces))), 64);
}

TEST(Debris, AFinThatHangsOnAnEdgeGoes) {
  // On the edge x = y = 4; and on its own far edge two more.
  const Repair repaired = repair(with_faces(kBox, {{6, 6, 0}, {6, 6, 4}, {7, 6, 0}, {6, 7, 0}},
                                            {{3, 8, 9, 7}, {8, 10, 9}, {8, 11, 9}}));
  EXPECT_DOUBLE_EQ(volume_of(repaired), 64);
}

TEST(Debris, AFinGoesAndTheHoleBesideItIsFilled) {
  const Repair repaired =
      repair(with_faces(without_face(kBox, 1), {{6, 6, 0}, {6, 6, 4}}, {{3, 8, 9, 7}}));
  EXPECT_DOUBLE_EQ(volume_of(repaired), 64);
}

TEST(Debris, AnOpenBoxIsNoDebrisButFilled) {
  const PolygonSoup soup = together(kBox, without_face(box({6, 0, 0}, {7, 1, 1}), 4));
  EXPECT_DOUBLE_EQ(volume_of(repair(soup)), 65);
}

TEST(Debris, AnOpenPartAsLargeAsTheRestIsNotDropped) {
  // A sheet bent to three sides of a cube: what it should bound cannot be told.
  PolygonSoup corner = box({10, 0, 0}, {14, 4, 4});
  for (const std::size_t i : {5u, 3u, 1u}) corner = without_face(corner, i);
  PolygonSoup soup = together(box({0, 0, 0}, {1, 1, 1}), corner);
  EXPECT_NE(import_error(repair(soup).soup).find("not closed"), std::string::npos);
}

TEST(Debris, AClosedThinPlateIsNoDebris) {
  const PolygonSoup soup = together(kBox, box({6, 0, 0}, {8, 2, 1e-9}));
  const Repair repaired = repair(soup);
  EXPECT_TRUE(repaired.changes.empty());
}

}  // namespace
}  // namespace spoctree
