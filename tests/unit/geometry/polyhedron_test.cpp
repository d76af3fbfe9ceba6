// Exact clipping against plain enumeration of plane triples.
#include "common/geometry/polyhedron_clipper.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/predicates.hpp"
#include "tests/support/grid_planes.hpp"
#include "tests/support/polyhedron_checks.hpp"

namespace spoctree {
namespace {

constexpr std::uint32_t kWhole = std::uint32_t{1} << kMaxDepth;

Rational rational_distance(const Rational& a, const Rational& b) { return abs(Rational(a - b)); }

/// A cell, the planes that have cut it, and the same as plain half-spaces.
struct Workpiece {
  std::vector<Plane> table;
  double half_side;
  Polyhedron polyhedron;
  std::vector<Plane> half_spaces;

  Workpiece(double half, const std::uint32_t (&lower)[3], std::uint32_t size) : half_side(half) {
    polyhedron = make_cell(lower, size, planes());
    for (const Polyhedron::Face& face : polyhedron.faces) {
      half_spaces.push_back(planes()[face.plane]);
    }
  }
  PlaneSet planes() const { return {table, half_side}; }
};

/// Equal in everything, to the last bit of the positions.
bool are_same(const Polyhedron& a, const Polyhedron& b) {
  const auto equal = [](const auto& x, const auto& y, auto&& compare) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), compare);
  };
  return equal(a.vertices, b.vertices,
               [](const PolyhedronVertex& x, const PolyhedronVertex& y) {
                 return x.position == y.position && x.error == y.error &&
                        std::equal(x.planes, x.planes + 3, y.planes);
               }) &&
         equal(a.corners, b.corners,
               [](const Polyhedron::Corner& x, const Polyhedron::Corner& y) {
                 return x.vertex == y.vertex && x.across == y.across;
               }) &&
         equal(a.faces, b.faces, [](const Polyhedron::Face& x, const Polyhedron::Face& y) {
           return x.plane == y.plane && x.first == y.first && x.count == y.count;
         });
}

/// Clips both sides by one more plane and compares with enumeration. False if nothing is left.
bool clip_and_check(Workpiece& work, PolyhedronClipper& clipper, PlaneRef ref) {
  const Plane plane = work.planes()[ref];
  const std::set<RationalPoint> before = exact_vertices(work.polyhedron, work.planes());
  const Rational whole = exact_volume(work.polyhedron, work.planes());
  Rational parts = 0;
  ClipResult results[2] = {ClipResult::Empty, ClipResult::Empty};
  Workpiece sides[2] = {work, work};
  for (int side = 0; side < 2; ++side) {
    Workpiece& part = sides[side];
    const ClipResult result =
        clipper.clip(part.polyhedron, side == 0 ? ref : ref.flipped(), part.planes());
    results[side] = result;
    part.half_spaces.push_back(side == 0 ? plane : plane.flipped());
    const std::set<RationalPoint> expected = enumerated_vertices(part.half_spaces);
    EXPECT_EQ(result == ClipResult::Empty, !has_interior(expected, part.half_spaces));
    if (result == ClipResult::Empty) continue;
    EXPECT_EQ(result == ClipResult::Unchanged, expected == before);
    EXPECT_EQ(structure_error(part.polyhedron, part.planes()), "");
    EXPECT_EQ(exact_vertices(part.polyhedron, part.planes()), expected);
    const Rational exact = exact_volume(part.polyhedron, part.planes());
    EXPECT_GT(exact, 0);
    EXPECT_LE(rational_distance(Rational(volume(part.polyhedron)), exact), Rational(0x1p-40));
    parts += exact;
  }
  EXPECT_EQ(parts, whole);
  EXPECT_FALSE(results[0] == ClipResult::Empty && results[1] == ClipResult::Empty);
  EXPECT_EQ(results[0] == ClipResult::Unchanged, results[1] == ClipResult::Empty);
  EXPECT_EQ(results[1] == ClipResult::Unchanged, results[0] == ClipResult::Empty);
  // The same again, both at once.
  Polyhedron halves[2];
  const PolyhedronClipper::Parts found =
      clipper.split(work.polyhedron, ref, work.planes(), halves[0], halves[1]);
  for (int side = 0; side < 2; ++side) {
    const bool has_part = results[side] != ClipResult::Empty;
    EXPECT_EQ(side == 0 ? found.inside : found.outside, has_part);
    EXPECT_TRUE(!has_part || are_same(halves[side], sides[side].polyhedron));
  }
  work = std::move(sides[0]);
  return results[0] != ClipResult::Empty;
}

TEST(MakeCell, IsAClosedBoxWithOutwardFacesAtEveryDepth) {
  Random random(1);
  const std::vector<Plane> table;
  for (int depth = 0; depth <= kMaxDepth; ++depth) {
    for (int k = 0; k < 5; ++k) {
      const double half_side = std::ldexp((1 << 19) + 1 + random.below(1 << 19), -20);
      const PlaneSet planes(table, half_side);
      const std::uint32_t size = kWhole >> static_cast<unsigned>(depth);
      std::uint32_t lower[3];
      for (std::uint32_t& index : lower) index = size * random.below(1u << depth);
      const Polyhedron cell = make_cell(lower, size, planes);
      EXPECT_EQ(structure_error(cell, planes), "");
      EXPECT_EQ(cell.faces.size(), 6u);
      EXPECT_EQ(cell.vertices.size(), 8u);
      std::set<RationalPoint> corners;
      const double side = 2 * half_side * std::ldexp(1.0, -depth);
      for (int corner = 0; corner < 8; ++corner) {
        RationalPoint point;
        for (int axis = 0; axis < 3; ++axis) {
          point[static_cast<std::size_t>(axis)] =
              -Rational(half_side) + Rational(side) * (lower[axis] / size + ((corner >> axis) & 1));
        }
        corners.insert(point);
      }
      EXPECT_EQ(exact_vertices(cell, planes), corners);
      for (const PolyhedronVertex& vertex : cell.vertices) EXPECT_EQ(vertex.error, 0);
      // Volume: side^3, and exact where side^3 is a double.
      EXPECT_EQ(exact_volume(cell, planes), Rational(side) * Rational(side) * Rational(side));
      EXPECT_NEAR(volume(cell) / (side * side * side), 1, 1e-15);
    }
  }
}

TEST(PolyhedronClipper, AgreesWithEnumerationForRandomPlanes) {
  Random random(2);
  PolyhedronClipper clipper;
  for (int k = 0; k < 12; ++k) {
    const std::uint32_t lower[3] = {0, 0, 0};
    Workpiece work(0.75, lower, kWhole);
    for (int i = 0; i < 7; ++i) {
      // Mostly tangential to a ball, so that many planes take part.
      const Vec3 normal = random_direction(random);
      work.table.push_back(grid_plane_through(normal, normal * random.between(-0.05, 0.6)));
      if (!clip_and_check(work, clipper, PlaneRef::of_table(static_cast<std::uint32_t>(i)))) break;
    }
  }
}

TEST(PolyhedronClipper, AgreesWithEnumerationForDegeneratePlanes) {
  Random random(3);
  PolyhedronClipper clipper;
  int unchanged_or_cut = 0;
  for (int k = 0; k < 150; ++k) {
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
    Workpiece work(1.0, lower, size);
    for (int i = 0; i < 6; ++i) {
      work.table.push_back(random_degenerate_plane(random, centre, half, work.table));
      if (!clip_and_check(work, clipper, PlaneRef::of_table(static_cast<std::uint32_t>(i)))) break;
      ++unchanged_or_cut;
    }
  }
  EXPECT_GT(unchanged_or_cut, 200);
}

TEST(PolyhedronClipper, CutsThroughVerticesWhereManyFacesMeet) {
  // A pyramid of many faces around one apex, cut through the apex, through edges, and off the apex.
  Random random(4);
  PolyhedronClipper clipper;
  const Vec3 apex{0.25, -0.125, 0.5};
  for (int k = 0; k < 6; ++k) {
    const std::uint32_t lower[3] = {0, 0, 0};
    Workpiece work(1.0, lower, kWhole);
    for (std::uint32_t i = 0; work.table.size() < 8; ++i) {
      Plane plane = random_plane_exactly_through(random, apex, 3);
      if (plane.normal.z < 0) plane = plane.flipped();
      if (plane.normal.z < 0.4 || plane.normal.z > 0.9) continue;
      work.table.push_back(plane);
      ASSERT_TRUE(clip_and_check(
          work, clipper, PlaneRef::of_table(static_cast<std::uint32_t>(work.table.size() - 1))));
    }
    const PlaneSet planes = work.planes();
    int at_apex = 0;
    for (const Polyhedron::Face& face : work.polyhedron.faces) {
      at_apex += exact_sign(exact_value(planes[face.plane], to_rational(apex))) == 0;
    }
    EXPECT_TRUE(exact_vertices(work.polyhedron, planes).contains(to_rational(apex)));
    EXPECT_GE(at_apex, 4);
    for (const int steps : {0, 1, -1}) {
      Workpiece copy = work;
      Plane cut = random_plane_exactly_through(random, apex, 3);
      cut.offset += steps * 0x1p-52;
      copy.table.push_back(cut);
      clip_and_check(copy, clipper,
                     PlaneRef::of_table(static_cast<std::uint32_t>(copy.table.size() - 1)));
    }
  }
}

TEST(PolyhedronClipper, CutsSliversAtTheResolutionOfTheGrid) {
  // Layers a grid step thick, at corners, faces and across.
  Random random(5);
  PolyhedronClipper clipper;
  for (int k = 0; k < 60; ++k) {
    const std::uint32_t lower[3] = {0, 0, 0};
    Workpiece work(1.0, lower, kWhole);
    Plane plane = random_degenerate_plane(random, Vec3{0.0}, 1, {});
    if (std::abs(plane.offset) > 1.99) continue;
    work.table.push_back(plane);
    if (!clip_and_check(work, clipper, PlaneRef::of_table(0))) continue;
    Plane back = plane.flipped();
    back.offset += 0x1p-52;
    work.table.push_back(back);
    clip_and_check(work, clipper, PlaneRef::of_table(1));
  }
}

TEST(PolyhedronClipper, SplitsByWallsAsTreesDo) {
  Random random(6);
  PolyhedronClipper clipper;
  for (int k = 0; k < 12; ++k) {
    const std::uint32_t lower[3] = {0, 0, 0};
    Workpiece work(1.0, lower, kWhole);
    work.table.push_back(random_degenerate_plane(random, Vec3{0.0}, 1, {}));
    if (!clip_and_check(work, clipper, PlaneRef::of_table(0))) continue;
    std::uint32_t from[3] = {0, 0, 0};
    for (std::uint32_t size = kWhole / 2; size > kWhole / 16; size /= 2) {
      bool is_left = true;
      for (int axis = 0; axis < 3 && is_left; ++axis) {
        const PlaneRef wall = PlaneRef::of_wall(axis, from[axis] + size);
        const bool upper = random.chance(0.5);
        is_left = clip_and_check(work, clipper, upper ? wall.flipped() : wall);
        if (upper) from[axis] += size;
      }
      if (!is_left) break;
    }
  }
}

TEST(SideOfVertex, IsExact) {
  Random random(7);
  for (int k = 0; k < 300; ++k) {
    std::vector<Plane> table;
    const Vec3 point = random_grid_point(random, 7);
    for (int i = 0; i < 6; ++i) table.push_back(random_plane_exactly_through(random, point, 7));
    table.push_back({table[5].normal, table[5].offset + 0x1p-52});
    table.push_back({table[5].normal, table[5].offset - 0x1p-52});
    table.push_back(table[0].flipped());
    table.push_back(grid_plane_through(random_direction(random), random_vector(random, 1)));
    const PlaneSet planes(table, 1.0);
    if (orientation_of_normals(table[0], table[1], table[2]) == 0) continue;
    const ApproximatePoint near = intersection_point(table[0], table[1], table[2]);
    const PolyhedronVertex vertex{
        near.position,
        near.error,
        {PlaneRef::of_table(0), PlaneRef::of_table(1).flipped(), PlaneRef::of_table(2)}};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
      const int expected = exact_sign(exact_value(table[i], to_rational(point)));
      EXPECT_EQ(side_of_vertex(vertex, PlaneRef::of_table(i), planes), expected);
      EXPECT_EQ(side_of_vertex(vertex, PlaneRef::of_table(i).flipped(), planes), -expected);
    }
  }
}

}  // namespace
}  // namespace spoctree
