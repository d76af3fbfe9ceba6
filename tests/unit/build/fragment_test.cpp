// Triangles cut by walls: nothing is lost, nothing is there twice, and every corner is what it
// says.
#include "server/build/fragment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/unit/build/cells.hpp"

namespace spoctree {
namespace {

Rational magnitude(const Rational& value) { return value < 0 ? Rational(-value) : value; }

/// A few solids whose vertices, edges and faces lie in walls, and some whose do not.
std::vector<Solid> solids(Random& random) {
  std::vector<Solid> all;
  all.push_back(box_solid(Vec3(-0.5, -0.25, -1), Vec3(0.5, 0.75, 0.25)));
  all.push_back(voxel_solid(random_voxels(2, random)));
  all.push_back(height_field_solid(random_height_field(4, Vec3(-1), 0.5, -0.5, 0.25, 5, random)));
  all.push_back(uneven_solid(4, random));
  return all;
}

TEST(SplitFragments, AreasOfThePartsAddUpTriangleByTriangle) {
  Random random(1);
  for (const Solid& solid : solids(random)) {
    const Incidence incidence(solid);
    for (const std::uint32_t depth : {1u, 2u, 3u}) {
      std::vector<double> sums(solid.triangles.size(), 0);
      for (const Cell& cell : cells_of(solid, incidence, depth)) {
        for (const Fragment& fragment : cell.boundary.fragments) {
          const double area = area_of(cell.boundary.corners_of(fragment));
          EXPECT_GT(area, 0);
          sums[fragment.triangle] += area;
        }
      }
      const FragmentList whole = whole_boundary(solid);
      for (const Fragment& fragment : whole.fragments) {
        EXPECT_NEAR(sums[fragment.triangle], area_of(whole.corners_of(fragment)), 1e-14);
      }
    }
  }
}

TEST(SplitFragments, CornersAreWhereTheirOriginsSay) {
  Random random(2);
  for (const Solid& solid : solids(random)) {
    const Incidence incidence(solid);
    for (const Cell& cell : cells_of(solid, incidence, 2)) {
      for (const Fragment& fragment : cell.boundary.fragments) {
        for (const FragmentCorner& corner : cell.boundary.corners_of(fragment)) {
          const RationalPoint exact = exact_point(corner, fragment.triangle, solid);
          EXPECT_LE(corner.error, 0x1p-40);
          for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            const Rational off = magnitude(Rational(corner.position[axis]) - exact[k]);
            EXPECT_LE(off, Rational(corner.error));
            const double lower = cell.wall(solid, axis, false);
            const double upper = cell.wall(solid, axis, true);
            if ((corner.pinned >> axis) & 1) {
              EXPECT_TRUE(corner.position[axis] == lower || corner.position[axis] == upper);
              // The plane of a triangle is rounded; the wall is not.
              EXPECT_LE(off, Rational(0x1p-50));
            } else {
              EXPECT_GT(exact[k], Rational(lower)) << "on the wall, or beyond it, but not pinned";
              EXPECT_LT(exact[k], Rational(upper)) << "on the wall, or beyond it, but not pinned";
            }
          }
        }
      }
    }
  }
}

TEST(SplitFragments, EdgesLieOnWhatTheyAreLabelledWith) {
  Random random(3);
  for (const Solid& solid : solids(random)) {
    const Incidence incidence(solid);
    for (const Cell& cell : cells_of(solid, incidence, 2)) {
      for (const Fragment& fragment : cell.boundary.fragments) {
        const auto corners = cell.boundary.corners_of(fragment);
        ASSERT_GE(corners.size(), 3u);
        for (std::size_t i = 0; i < corners.size(); ++i) {
          const FragmentCorner& from = corners[i];
          const FragmentCorner& to = corners[(i + 1) % corners.size()];
          EXPECT_NE(from.position, to.position);
          if (from.edge >= 3) {
            const int axis = from.edge - 3;
            EXPECT_TRUE((from.pinned >> axis) & (to.pinned >> axis) & 1);
            EXPECT_EQ(from.position[axis], to.position[axis]);
            continue;
          }
          const SolidTriangle& triangle = solid.triangles[fragment.triangle];
          const std::uint32_t u = triangle.vertex[from.edge];
          const std::uint32_t v = triangle.vertex[(from.edge + 1) % 3];
          for (const FragmentCorner* corner : {&from, &to}) {
            const bool is_end = corner->origin == FragmentCorner::Origin::Vertex &&
                                (corner->a == u || corner->a == v);
            const bool is_between = corner->origin == FragmentCorner::Origin::Edge &&
                                    corner->a == std::min(u, v) && corner->b == std::max(u, v);
            EXPECT_TRUE(is_end || is_between);
          }
        }
      }
    }
  }
}

TEST(SplitFragments, ATriangleInTheWallGoesToTheSideOfItsMaterial) {
  const Solid solid = box_solid(Vec3(-0.5), Vec3(0.5));
  const Incidence incidence(solid);
  const CornerSides sides(solid, incidence);
  const FragmentList whole = whole_boundary(solid);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double wall : {-0.5, 0.5}) {
      FragmentList lower;
      FragmentList upper;
      split_fragments(whole, whole.fragments, solid, sides, axis, wall, lower, upper);
      EXPECT_EQ(lower.fragments.size(), wall > 0 ? 12u : 0u);
      EXPECT_EQ(upper.fragments.size(), wall > 0 ? 0u : 12u);
    }
  }
}

TEST(SplitFragments, ATriangleThatTouchesTheWallWithAnEdgeOrACornerStaysOnItsSide) {
  // A tetrahedron on the wall z = 0 with one corner, then with one edge, then with a face.
  const std::vector<std::array<std::uint32_t, 3>> faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Vec3 apex(0.25, 0.25, 0.5);
  for (const int raised : {0, 1, 2}) {
    std::vector<Vec3> points{{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, apex};
    if (raised >= 1) points[2].z = 0.25;
    if (raised >= 2) points[1].z = 0.25;
    const Solid solid = hand_solid(points, faces);
    const Incidence incidence(solid);
    const CornerSides sides(solid, incidence);
    FragmentList lower;
    FragmentList upper;
    const FragmentList whole = whole_boundary(solid);
    split_fragments(whole, whole.fragments, solid, sides, 2, 0.0, lower, upper);
    EXPECT_EQ(lower.fragments.size(), 0u);
    EXPECT_EQ(lower.corners.size(), 0u);
    EXPECT_EQ(upper.fragments.size(), 4u);
    EXPECT_EQ(upper.corners.size(), 12u);
  }
}

TEST(CornerSides, AreThoseOfTheExactPointsButForIncidence) {
  Random random(4);
  for (const Solid& solid : solids(random)) {
    const Incidence incidence(solid);
    const CornerSides sides(solid, incidence);
    // Which vertices are corners of a face in which plane, read off the triangles.
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> is_incident;
    for (const SolidTriangle& t : solid.triangles) {
      for (const std::uint32_t v : t.vertex) is_incident[{v, solid.facet_plane[t.facet]}] = true;
    }
    std::size_t on = 0;
    for (const Cell& cell : cells_of(solid, incidence, 2)) {
      for (const Fragment& fragment : cell.boundary.fragments) {
        const std::uint32_t own = solid.facet_plane[solid.triangles[fragment.triangle].facet];
        for (const FragmentCorner& corner : cell.boundary.corners_of(fragment)) {
          const RationalPoint exact = exact_point(corner, fragment.triangle, solid);
          for (std::uint32_t plane = 0; plane < solid.planes.size(); ++plane) {
            const bool is_on =
                (corner.origin == FragmentCorner::Origin::Face && plane == own) ||
                (corner.origin != FragmentCorner::Origin::Face && is_incident[{corner.a, plane}] &&
                 (corner.origin == FragmentCorner::Origin::Vertex ||
                  is_incident[{corner.b, plane}]));
            const int expected = is_on ? 0 : exact_sign(exact_value(solid.planes[plane], exact));
            ASSERT_EQ(sides.side(corner, fragment.triangle, plane), expected);
            on += is_on;
          }
        }
      }
    }
    EXPECT_GT(on, 10u);
  }
}

}  // namespace
}  // namespace spoctree
