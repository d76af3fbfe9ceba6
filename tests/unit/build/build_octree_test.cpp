// Whole trees of solids that know their inside, degenerate ones above all: faces, edges and
// vertices exactly in cell walls, and in the walls of the universe cube.
#include "server/build/build_octree.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/tree/classify.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/encode.hpp"
#include "server/build/certify.hpp"
#include "tests/support/grid_planes.hpp"
#include "tests/unit/build/cells.hpp"

namespace spoctree {
namespace {

BuiltOctree build(const Solid& solid, const SpRules& rules = kPaperRules) {
  const SolidQueries queries(solid);
  BuildOptions options;
  options.rules = rules;
  BuiltOctree built = build_octree(solid, queries, options);
  certify(built, solid, queries);
  EXPECT_EQ(validate(built.tree), std::vector<std::string>{});
  EXPECT_TRUE(built.tree.is_complete());
  const LevelStatement& last = built.tree.levels.back().statement;
  EXPECT_EQ(last.inner_volume, last.outer_volume);
  EXPECT_NEAR(last.inner_volume, solid.volume, 1e-13);
  return built;
}

/// The rules under which every solid is tried.
std::vector<SpRules> all_rules() {
  return {{}, kPaperRules, {6, kMaxDepth}, {0, 0}, {0, 1}, {0, 2}};
}

/// Every level of the tree against what is so at a point: In, Out, or (exactly) On. Before the last
/// level a point on the boundary may be anything but Out.
void expect_right(const Octree& tree, Vec3 point, PointClass truth, std::size_t& wrong) {
  const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
  for (std::uint32_t k = 0; k <= last; ++k) {
    const PointClass now = classify_point(tree, point, k);
    const bool is_right = now == truth || (k < last && now == PointClass::Unknown);
    if (!is_right && ++wrong <= 3) {
      ADD_FAILURE() << "level " << k << " of " << last << " says " << static_cast<int>(now)
                    << " of (" << point.x << ", " << point.y << ", " << point.z << "), which is "
                    << static_cast<int>(truth);
    }
  }
}

TEST(BuildOctree, IsExactForVoxelsEvenOnTheirBoundary) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Voxels voxels = random_voxels(2, random);
    ASSERT_TRUE(is_manifold(voxels));
    const Solid solid = voxel_solid(voxels);
    for (const SpRules& rules : all_rules()) {
      const Octree tree = build(solid, rules).tree;
      std::size_t wrong = 0;
      for (int i = 0; i < 1500; ++i) {
        // Multiples of 1/4: half of the coordinates are on walls between voxels.
        int at[3];
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis) {
          at[axis] = static_cast<int>(random.below(9));
          point[axis] = at[axis] * 0.25 - 1;
        }
        bool any_full = false;
        bool any_empty = false;
        for (int side = 0; side < 8; ++side) {
          int cell[3];
          for (int axis = 0; axis < 3; ++axis) {
            cell[axis] = (at[axis] - ((side >> axis) & 1 ? 0 : 1 - at[axis] % 2)) >> 1;
          }
          (voxels(cell[0], cell[1], cell[2]) ? any_full : any_empty) = true;
        }
        expect_right(tree, point,
                     any_full ? (any_empty ? PointClass::On : PointClass::In) : PointClass::Out,
                     wrong);
      }
      EXPECT_EQ(wrong, 0u);
    }
  }
}

TEST(BuildOctree, IsExactForHeightFieldsOverTheWalls) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const HeightField field =
        seed % 2 == 0 ? random_height_field(4, Vec3(-1), 0.5, -0.75, 0.25, 8, random)
                      : random_height_field(6, Vec3(-0.75), 0.25, -0.5, 0.0625, 20, random);
    const Solid solid = height_field_solid(field);
    EXPECT_NEAR(solid.volume, field.volume(), 1e-13);
    for (const SpRules& rules : all_rules()) {
      const Octree tree = build(solid, rules).tree;
      std::size_t wrong = 0;
      for (int i = 0; i < 1000; ++i) {
        Vec3 point = random_vector(random, 1);
        if (i % 3 == 0) {  // in walls of cells
          for (int axis = 0; axis < 3; ++axis) {
            if (random.chance(0.6)) point[axis] = std::nearbyint(point[axis] * 16) / 16;
          }
        }
        if (i % 3 == 1) {  // just above or below the top
          const double off = (random.chance(0.5) ? 1 : -1) * std::pow(10, random.between(-12, -2));
          const int x = static_cast<int>(random.below(static_cast<std::uint32_t>(field.cells)));
          const int y = static_cast<int>(random.below(static_cast<std::uint32_t>(field.cells)));
          const double t = random.unit();
          const double h =
              field.height(x, y) + t * (field.height(x + 1, y + 1) - field.height(x, y));
          point = field.corner + Vec3(x + t, y + t, 0) * field.step;
          point.z = h + off;
        }
        const auto truth = field.is_inside(point);
        if (truth) {
          expect_right(tree, point, *truth ? PointClass::In : PointClass::Out, wrong);
        }
      }
      EXPECT_EQ(wrong, 0u);
    }
  }
}

TEST(BuildOctree, IsExactForFacesNearlyInOnePlane) {
  for (const int bits : {20, 30, 36, 40, 44, 47, 49, 50}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(testing::Message() << bits << " bits, seed " << seed);
      Random random(seed);
      const HeightField field = random_height_field(4, Vec3(-0.8125), 0.40625, 0.28125,
                                                    std::ldexp(1.0, -bits), 4, random);
      const Solid solid = height_field_solid(field);
      const SolidQueries queries(solid);
      const Octree tree = build(solid).tree;
      std::size_t wrong = 0;
      for (int i = 0; i < 1000; ++i) {
        Vec3 point = random_vector(random, 1);
        if (i % 2 == 0) {
          point.z = 0.28125 + (random.chance(0.5) ? 1 : -1) * std::pow(10, random.between(-12, -2));
        }
        const auto truth = field.is_inside(point);
        if (truth && queries.distance(point) > 1e-13) {
          expect_right(tree, point, *truth ? PointClass::In : PointClass::Out, wrong);
        }
      }
      EXPECT_EQ(wrong, 0u);
    }
  }
}

TEST(BuildOctree, NoLevelLosesAVertexOfTheSolid) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Solid solid = uneven_solid(5, random);
    const Octree tree = build(solid).tree;
    for (std::uint32_t k = 0; k < tree.levels.size(); ++k) {
      for (const Vec3 vertex : solid.vertices) {
        ASSERT_NE(classify_point(tree, vertex, k), PointClass::Out) << "level " << k;
      }
    }
  }
}

TEST(BuildOctree, UnitBoxesAnywhereOnTheWallsAreOneConvexNode) {
  for (int position = 0; position < 27; ++position) {
    const Vec3 lower = Vec3(position % 3, position / 3 % 3, position / 9) * 0.5 - 1.0;
    const Solid solid = box_solid(lower, lower + 1.0);
    const Octree tree = build(solid).tree;
    ASSERT_EQ(tree.levels.size(), 1u);
    EXPECT_EQ(tree.levels[0].kinds[0], NodeKind::Convex);
    EXPECT_EQ(tree.planes.size(), 6u);
  }
}

TEST(BuildOctree, PlanesStandOnceInOrderOfFirstUseAndAreTheSolids) {
  Random random(7);
  const Solid solid = uneven_solid(5, random);
  const Octree tree = build(solid).tree;
  std::uint32_t seen = 0;
  for (const Level& level : tree.levels) {
    for (const std::uint32_t plane : level.references) {
      ASSERT_LE(plane, seen);
      seen += plane == seen;
    }
  }
  EXPECT_EQ(seen, tree.planes.size());
  for (std::size_t i = 0; i < tree.planes.size(); ++i) {
    EXPECT_EQ(std::count(tree.planes.begin(), tree.planes.end(), tree.planes[i]), 1);
    EXPECT_EQ(std::count(solid.planes.begin(), solid.planes.end(), tree.planes[i]), 1);
  }
}

TEST(BuildOctree, MakesTheSameBytesEveryTime) {
  Random random(8);
  const Solid solid = uneven_solid(8, random);
  SourceInfo source;
  source.name = "it";
  const std::string once = encode_stream(build(solid).tree, source);
  EXPECT_EQ(encode_stream(build(solid).tree, source), once);
}

TEST(BuildOctree, ReportsProgressThatGrowsToOne) {
  Random random(9);
  const Solid solid = uneven_solid(12, random);
  const SolidQueries queries(solid);
  std::vector<double> reported;
  BuildOptions options;
  options.progress = [&](double fraction) { reported.push_back(fraction); };
  build_octree(solid, queries, options);
  EXPECT_FALSE(reported.empty());
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_LE(reported.back(), 1);
}

}  // namespace
}  // namespace spoctree
