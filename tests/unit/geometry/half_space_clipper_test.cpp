// Clipping by many planes at once against clipping by one after the other, and against solids whose
// corners are known.
#include "common/geometry/half_space_clipper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "common/geometry/polyhedron_clipper.hpp"
#include "tests/support/grid_planes.hpp"
#include "tests/support/polyhedron_checks.hpp"

namespace spoctree {
namespace {

constexpr std::uint32_t kWhole = std::uint32_t{1} << kMaxDepth;
constexpr std::uint32_t kOrigin[3] = {0, 0, 0};

std::vector<std::uint32_t> all_of(const std::vector<Plane>& table) {
  std::vector<std::uint32_t> all(table.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

/// The planes that a polyhedron has faces on.
std::set<PlaneRef> planes_of(const Polyhedron& polyhedron) {
  std::set<PlaneRef> planes;
  for (const Polyhedron::Face& face : polyhedron.faces) planes.insert(face.plane);
  return planes;
}

/// False if nothing is left, which both ways must agree about.
bool clip_both_ways(const Polyhedron& whole, const std::vector<Plane>& table, double half_side,
                    HalfSpaceClipper& clipper) {
  const PlaneSet planes(table, half_side);
  Polyhedron expected = whole;
  PolyhedronClipper one_by_one;
  bool is_left = true;
  for (const std::uint32_t plane : all_of(table)) {
    is_left = is_left &&
              one_by_one.clip(expected, PlaneRef::of_table(plane), planes) != ClipResult::Empty;
  }
  Polyhedron clipped = whole;
  EXPECT_EQ(clipper.clip(clipped, all_of(table), planes), is_left);
  if (!is_left) return false;
  EXPECT_EQ(structure_error(clipped, planes), "");
  EXPECT_EQ(exact_vertices(clipped, planes), exact_vertices(expected, planes));
  EXPECT_EQ(clipped.vertices.size(), expected.vertices.size());
  EXPECT_EQ(planes_of(clipped).size(), planes_of(expected).size());
  EXPECT_NEAR(volume(clipped), volume(expected), 1e-12);
  return true;
}

TEST(HalfSpaceClipper, AgreesWithOneByOneForRandomPlanes) {
  Random random(1);
  HalfSpaceClipper clipper;
  for (int k = 0; k < 20; ++k) {
    std::vector<Plane> table;
    for (int i = 0; i < 40; ++i) {
      const Vec3 normal = random_direction(random);
      table.push_back(grid_plane_through(normal, normal * random.between(0.4, 0.7)));
    }
    const PlaneSet planes(table, 0.75);
    EXPECT_TRUE(clip_both_ways(make_cell(kOrigin, kWhole, planes), table, 0.75, clipper));
  }
}

TEST(HalfSpaceClipper, AgreesWithOneByOneForDegeneratePlanes) {
  Random random(2);
  HalfSpaceClipper clipper;
  int left = 0;
  for (int k = 0; k < 600; ++k) {
    const int depth = random_integer(random, 0, 3);
    const std::uint32_t size = kWhole >> static_cast<unsigned>(depth);
    std::uint32_t lower[3];
    Vec3 centre;
    const double half = std::ldexp(1.0, -depth);
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t index = random.below(1u << depth);
      lower[axis] = index * size;
      centre[axis] = -1 + half * (2 * index + 1);
    }
    std::vector<Plane> table;
    const int count = random_integer(random, 1, 9);
    for (int i = 0; i < count; ++i) {
      Plane plane = random_degenerate_plane(random, centre, half, table);
      // Mostly so that something is left.
      const bool is_outwards = glm::dot(plane.normal, centre) <= plane.offset;
      if (!is_outwards && random.below(8) != 0) plane = plane.flipped();
      table.push_back(plane);
    }
    const PlaneSet planes(table, 1.0);
    left += clip_both_ways(make_cell(lower, size, planes), table, 1.0, clipper);
  }
  EXPECT_GT(left, 200);
}

TEST(HalfSpaceClipper, KeepsAPointWhereManyPlanesMeetExactly) {
  Random random(3);
  HalfSpaceClipper clipper;
  const Vec3 apex{0.25, -0.125, 0.5};
  for (int k = 0; k < 6; ++k) {
    std::vector<Plane> table;
    while (table.size() < 40) {
      Plane plane = random_plane_exactly_through(random, apex, 3);
      if (plane.normal.z < 0) plane = plane.flipped();
      if (plane.normal.z > 0.4 && plane.normal.z < 0.9) table.push_back(plane);
    }
    const PlaneSet planes(table, 1.0);
    const Polyhedron cell = make_cell(kOrigin, kWhole, planes);
    EXPECT_TRUE(clip_both_ways(cell, table, 1.0, clipper));
    Polyhedron clipped = cell;
    ASSERT_TRUE(clipper.clip(clipped, all_of(table), planes));
    EXPECT_TRUE(exact_vertices(clipped, planes).contains(to_rational(apex)));
  }
}

TEST(HalfSpaceClipper, FindsAPrismOfManySides) {
  constexpr std::uint32_t kSides = 3000;
  std::vector<Plane> table;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / kSides;
    const Vec3 normal{std::cos(angle), std::sin(angle), 0};
    table.push_back(grid_plane_through(normal, normal * 0.5));
  }
  const PlaneSet planes(table, 1.0);
  Polyhedron prism = make_cell(kOrigin, kWhole, planes);
  ASSERT_TRUE(HalfSpaceClipper().clip(prism, all_of(table), planes));
  EXPECT_EQ(prism.vertices.size(), 2 * kSides);
  ASSERT_EQ(prism.faces.size(), kSides + 2);
  // The walls above and below are left, and come first.
  for (std::uint32_t f = 0; f < 2; ++f) {
    EXPECT_EQ(prism.faces[f].plane.axis(), 2);
    EXPECT_EQ(prism.faces[f].count, kSides);
  }
  for (std::uint32_t i = 0; i < kSides; ++i) {
    EXPECT_EQ(prism.faces[2 + i].plane, PlaneRef::of_table(i));
    EXPECT_EQ(prism.faces[2 + i].count, 4u);
  }
  // A regular polygon around a circle, twice as high as the cube's half side.
  const double area = kSides * 0.25 * std::tan(std::numbers::pi / kSides);
  EXPECT_NEAR(volume(prism), 2 * area, 1e-12);
}

TEST(HalfSpaceClipper, CutsAnyPolyhedronWithManyFaces) {
  // By two parts of the planes, one after the other, as by all at once.
  Random random(4);
  std::vector<Plane> table;
  for (int i = 0; i < 400; ++i) {
    const Vec3 normal = random_direction(random);
    table.push_back(grid_plane_through(normal, normal * 0.5));
  }
  const PlaneSet planes(table, 1.0);
  const std::vector<std::uint32_t> all = all_of(table);
  HalfSpaceClipper clipper;
  Polyhedron at_once = make_cell(kOrigin, kWhole, planes);
  Polyhedron in_parts = at_once;
  ASSERT_TRUE(clipper.clip(at_once, all, planes));
  ASSERT_TRUE(clipper.clip(in_parts, std::span(all).first(250), planes));
  ASSERT_TRUE(clipper.clip(in_parts, std::span(all).subspan(250), planes));
  EXPECT_EQ(exact_vertices(in_parts, planes), exact_vertices(at_once, planes));
  EXPECT_EQ(planes_of(in_parts), planes_of(at_once));
  EXPECT_EQ(at_once.faces.size(), table.size());
}

}  // namespace
}  // namespace spoctree
