// Trees of cubes: merged, measured and counted, against their cells one by one.
#include "common/tree/cube_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "common/tree/merge_siblings.hpp"
#include "common/tree/validate.hpp"
#include "tests/support/random.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

Voxels random_cells(int depth, double share, std::uint64_t seed) {
  Random random(seed);
  std::vector<bool> full(std::size_t{1} << (3 * depth));
  for (std::size_t i = 0; i < full.size(); ++i) full[i] = random.chance(share);
  return {depth, [full, depth](int x, int y, int z) {
            return full[static_cast<std::size_t>(((z << depth) + y) << depth | x)];
          }};
}

void expect_same_nodes(const Octree& a, const Octree& b) {
  ASSERT_EQ(a.levels.size(), b.levels.size());
  for (std::size_t k = 0; k < a.levels.size(); ++k) {
    EXPECT_EQ(a.levels[k].kinds, b.levels[k].kinds) << "level " << k;
    EXPECT_EQ(a.levels[k].first_child, b.levels[k].first_child) << "level " << k;
  }
}

TEST(MergeSiblings, LeavesTheTreeThatHasAsFewNodesAsCanBe) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const double share : {0.02, 0.5, 0.95, 1.0}) {
      const Voxels voxels = random_cells(3, share, seed);
      Octree tree = tree_of(voxels, false);
      const auto former = merge_siblings(tree);
      EXPECT_EQ(validate(tree), std::vector<std::string>{});
      expect_same_nodes(tree, tree_of(voxels));
      ASSERT_EQ(former.size(), tree.levels.size());
      for (std::size_t k = 0; k < former.size(); ++k) {
        ASSERT_EQ(former[k].size(), tree.levels[k].size());
      }
    }
  }
}

TEST(MergeSiblings, SaysWhichNodesAreLeft) {
  // Of two octants alike in themselves, and one that is not.
  const Voxels voxels{2,
                      [](int x, int y, int z) { return z < 2 && !(x == 0 && y == 0 && z == 0); }};
  Octree tree = tree_of(voxels, false);
  const auto former = merge_siblings(tree);
  ASSERT_EQ(former.size(), 3u);
  EXPECT_EQ(former[1], (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(former[2], former[1]);  // the children of the first octant
  EXPECT_EQ(tree.levels[1].grey_count, 1u);
}

TEST(MergeSiblings, AnEmptyTreeIsItsRoot) {
  Octree tree = tree_of({3, [](int, int, int) { return false; }}, false);
  merge_siblings(tree);
  ASSERT_EQ(tree.levels.size(), 1u);
  EXPECT_EQ(tree.levels[0].kinds, std::vector<NodeKind>{NodeKind::White});
}

TEST(CubeMeasures, AreTheSumsOverTheCells) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const double share : {0.1, 0.5, 0.9}) {
      const Voxels voxels = random_cells(3, share, seed);
      for (const bool merged : {false, true}) {
        Octree tree = tree_of(voxels, merged);
        measure_cubes(tree);
        const double side = tree.universe.side() / 8;
        double cells = 0;
        double squares = 0;
        for (int z = 0; z < 8; ++z) {
          for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 8; ++x) {
              if (!voxels(x, y, z)) continue;
              ++cells;
              squares += 6 - voxels(x + 1, y, z) - voxels(x - 1, y, z) - voxels(x, y + 1, z) -
                         voxels(x, y - 1, z) - voxels(x, y, z + 1) - voxels(x, y, z - 1);
            }
          }
        }
        const LevelStatement& last = tree.levels.back().statement;
        EXPECT_NEAR(last.inner_volume, cells * std::pow(side, 3), 1e-12);
        EXPECT_EQ(last.outer_volume, last.inner_volume);
        EXPECT_NEAR(last.inner_area, squares * side * side, 1e-12);
        EXPECT_EQ(last.outer_area, last.inner_area);
        for (const Level& level : tree.levels) {
          EXPECT_TRUE(is_valid(level.statement));
          EXPECT_EQ(level.statement.outer_area, last.outer_area);
        }
      }
    }
  }
}

TEST(CubeMeasures, CountTheCubesThatAreNotSurrounded) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Voxels voxels = random_cells(3, 0.9, seed);
    std::uint64_t exposed = 0;
    for (int i = 0; i < 512; ++i) {
      const int x = i % 8, y = i / 8 % 8, z = i / 64;
      const bool is_inside = voxels(x + 1, y, z) && voxels(x - 1, y, z) && voxels(x, y + 1, z) &&
                             voxels(x, y - 1, z) && voxels(x, y, z + 1) && voxels(x, y, z - 1);
      exposed += voxels(x, y, z) && !is_inside;
    }
    EXPECT_EQ(count_exposed_cubes(tree_of(voxels, false)), exposed);
  }
  // A block of four cells a side at a corner of the middle: its eight octants are one.
  const Voxels block{3, [](int x, int y, int z) { return x < 4 && y < 4 && z < 4; }};
  EXPECT_EQ(count_exposed_cubes(tree_of(block)), 1u);
}

}  // namespace
}  // namespace spoctree
