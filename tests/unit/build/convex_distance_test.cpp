// How far one convex polyhedron reaches beyond another, where faces have no extent in doubles.
#include "server/build/convex_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "common/geometry/polyhedron_clipper.hpp"

namespace spoctree {
namespace {

double on_grid(double x) { return std::ldexp(std::nearbyint(std::ldexp(x, 52)), -52); }

/// The plane of a normal through a point, nearly.
Plane plane_through(Vec3 normal, Vec3 point) {
  normal = glm::normalize(normal);
  normal = {on_grid(normal.x), on_grid(normal.y), on_grid(normal.z)};
  return {normal, on_grid(glm::dot(normal, point))};
}

TEST(LargestDistance, IsThatOfTheFarthestCorner) {
  // The cube's halves, and a quarter from its far wall.
  const std::vector<Plane> table = {{{1, 0, 0}, 0.0}, {{-1, 0, 0}, -0.5}};
  const PlaneSet planes(table, 1);
  PolyhedronClipper clipper;
  Polyhedron piece = make_cell({0, 0, 0}, 1u << kMaxDepth, planes);
  Polyhedron part = piece;
  ASSERT_EQ(clipper.clip(piece, PlaneRef::of_table(0), planes), ClipResult::Cut);
  ASSERT_EQ(clipper.clip(part, PlaneRef::of_table(1), planes), ClipResult::Cut);
  EXPECT_NEAR(largest_distance(part, piece, planes), 1, 1e-12);
  EXPECT_NEAR(largest_distance(part, piece, planes, 1.1), 1, 1e-12);
  EXPECT_GE(largest_distance(part, piece, planes, 0.9), 0.9);
}

TEST(LargestDistance, IsNotFooledByFacesWhoseCornersAreTheSameDoubles) {
  // Pyramids with a fifth plane through their tips, nearly: what it cuts off, if anything, is about
  // as small as the spacing of doubles there, so that the new face may have its corners all in the
  // same doubles. No point far away is over it, however near to its plane.
  int without_extent = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 tip{0.7 + i * 1e-3 / 3, 0.6 + i * 1e-3 / 7, 0.65 + i * 1e-3 / 11};
    const std::vector<Plane> table = {plane_through({2, 1, 1}, tip),
                                      plane_through({-2, 1, 1}, tip),
                                      plane_through({1, 2, 1}, tip),
                                      plane_through({1, -2, 1}, tip),
                                      {{0, 0, 1}, on_grid(tip.z) - (i % 4) * 0x1p-52}};
    const PlaneSet planes(table, 1);
    PolyhedronClipper clipper;
    Polyhedron piece = make_cell({0, 0, 0}, 1u << kMaxDepth, planes);
    for (std::uint32_t plane = 0; plane < table.size(); ++plane) {
      ASSERT_NE(clipper.clip(piece, PlaneRef::of_table(plane), planes), ClipResult::Empty);
    }
    for (const Polyhedron::Face& face : piece.faces) {
      const Vec3 first = piece.vertices[piece.loop(face).front().vertex].position;
      bool has_extent = false;
      for (const Polyhedron::Corner& corner : piece.loop(face)) {
        has_extent |= piece.vertices[corner.vertex].position != first;
      }
      without_extent += !has_extent;
    }
    // Only its corners count: one, in the fifth plane. Its distance is at least that from any plane
    // that the piece is inside of.
    const Vec3 corner{-0.9, -0.8, table[4].offset};
    double least = 0;
    for (const Plane& plane : table) {
      least = std::max(least, glm::dot(plane.normal, corner) - plane.offset);
    }
    ASSERT_GT(least, 0.1);
    Polyhedron part;
    part.vertices.push_back({corner, 0, {}});
    EXPECT_GE(largest_distance(part, piece, planes), least - 1e-12) << i;
  }
  EXPECT_GT(without_extent, 0);
}

}  // namespace
}  // namespace spoctree
