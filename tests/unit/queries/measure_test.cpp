#include "client/queries/measure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "client/queries/shells.hpp"
#include "client/rebuild/surface.hpp"
#include "common/tree/piece_bounds.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

/// Cells of a classical octree of two levels below a GREY root: 64 of them, `full` says which hold
/// material. Universe coordinates are model coordinates.
template <class IsFull>
Octree voxel_tree(IsFull&& is_full) {
  Octree tree;
  tree.levels.resize(3);
  tree.levels[0].append(NodeKind::Grey, {});
  for (unsigned octant = 0; octant < 8; ++octant) {
    tree.levels[1].append(NodeKind::Grey, {});
    for (unsigned child = 0; child < 8; ++child) {
      int cell[3];
      for (unsigned axis = 0; axis < 3; ++axis) {
        cell[axis] = static_cast<int>(2 * ((octant >> axis) & 1) + ((child >> axis) & 1));
      }
      const bool full = is_full(cell[0], cell[1], cell[2]);
      tree.levels[2].append(full ? NodeKind::Black : NodeKind::White, {});
    }
  }
  return tree;
}

TEST(Measure, KnowsACube) {
  const Octree tree = cube_tree();  // side 2 around (10, 20, 30)
  const Measures measures = measure(tree, 0);
  EXPECT_TRUE(measures.is_exact);
  EXPECT_EQ(measures.volume.lower, 8);
  EXPECT_EQ(measures.volume.upper, 8);
  EXPECT_EQ(measures.area.lower, 24);
  EXPECT_EQ(measures.area.upper, 24);
  ASSERT_TRUE(measures.inner_box && measures.outer_box);
  EXPECT_EQ(measures.outer_box->lower, Vec3(9, 19, 29));
  EXPECT_EQ(measures.outer_box->upper, Vec3(11, 21, 31));
  EXPECT_EQ(measures.inner_box->lower, Vec3(9, 19, 29));
  EXPECT_EQ(measures.components, 1u);
  EXPECT_EQ(measures.cavities, 0u);
}

TEST(Measure, CountsComponentsAndCavities) {
  // Two rooms apart in one block, and a block in the corner that touches nothing.
  const Octree rooms = voxel_tree([](int x, int y, int z) {
    return !((x == 1 || x == 2) && (y == 1 || y == 2) && (z == 1 || z == 2) &&
             (x + y + z) % 2 == 1 && x + y != 2);
  });
  Measures measures = measure(rooms, 2);
  EXPECT_EQ(measures.components, 1u);
  EXPECT_EQ(measures.cavities, 3u);  // (1,2,2) (2,1,2) (2,2,1): edges in common are no passage
  EXPECT_NEAR(measures.volume.lower, 61.0 / 8, 1e-14);
  const Octree corners =
      voxel_tree([](int x, int y, int z) { return x % 3 == 0 && y % 3 == 0 && z % 3 == 0; });
  measures = measure(corners, 2);
  EXPECT_EQ(measures.components, 8u);
  EXPECT_EQ(measures.cavities, 0u);
  EXPECT_NEAR(measures.volume.lower, 1, 1e-14);
  EXPECT_NEAR(measures.area.lower, 8 * 6.0 / 4, 1e-14);
  // A cube in the room of a shell.
  const auto is_middle = [](int v) { return v == 1 || v == 2; };
  const Octree shell = voxel_tree(
      [&](int x, int y, int z) { return !(is_middle(x) && is_middle(y) && is_middle(z)); });
  measures = measure(shell, 2);
  EXPECT_EQ(measures.components, 1u);
  EXPECT_EQ(measures.cavities, 1u);
  const auto shells = find_shells(rebuild_surface(shell));
  ASSERT_EQ(shells.size(), 2u);
  EXPECT_EQ(shells[0].face_count, 6u);
  EXPECT_NEAR(std::max(shells[0].volume, shells[1].volume), 8, 1e-14);
  EXPECT_NEAR(std::min(shells[0].volume, shells[1].volume), -1, 1e-14);
}

TEST(Measure, BoundsWhatIsNotKnownYet) {
  const Octree tree = voxel_tree([](int x, int, int) { return x < 2; });
  const Measures nothing = measure(tree, 0);
  EXPECT_FALSE(nothing.is_exact);
  EXPECT_EQ(nothing.volume.lower, 0);
  EXPECT_NEAR(nothing.volume.upper, 8, 1e-10);
  EXPECT_GE(nothing.volume.upper, 8);
  EXPECT_FALSE(nothing.inner_box);
  ASSERT_TRUE(nothing.outer_box);
  EXPECT_LE(nothing.outer_box->upper.x, 1 + 1e-12);
  EXPECT_FALSE(nothing.components);
  EXPECT_FALSE(nothing.cavities);
}

TEST(Measure, HasNothingToSayOfAnEmptySolid) {
  const Octree tree = voxel_tree([](int, int, int) { return false; });
  const Measures measures = measure(tree, 2);
  EXPECT_TRUE(measures.is_exact);
  EXPECT_EQ(measures.volume.upper, 0);
  EXPECT_EQ(measures.area.upper, 0);
  EXPECT_FALSE(measures.outer_box);
  EXPECT_EQ(measures.components, 0u);
  EXPECT_NE(to_json(measures, "m", "").find("\"box\":{\"inner\":null,\"outer\":null}"),
            std::string::npos);
}

TEST(Measure, TakesTheBallsAreaWhereTheStatementSaysLess) {
  Octree tree = voxel_tree([](int, int, int) { return true; });
  tree.levels[1] = {};
  for (int octant = 0; octant < 8; ++octant) {
    tree.levels[1].append(octant == 0 ? NodeKind::Grey : NodeKind::Black, {});
  }
  tree.levels[2].kinds.resize(8);
  tree.levels[1].statement.outer_area = 24;
  const Measures measures = measure(tree, 1);
  // 7 of 8 units of volume are certain; a ball of that volume:
  const double radius = std::cbrt(7 * 3 / (4 * M_PI));
  EXPECT_NEAR(measures.area.lower, 4 * M_PI * radius * radius, 1e-9);
  EXPECT_NEAR(measures.area.upper, 24, 1e-9);
}

TEST(Measure, IsTextForPeopleAndForPrograms) {
  const Measures measures = measure(cube_tree(), 0);
  EXPECT_EQ(to_table(measures, "mm"),
            "level       0, the last one: exact\n"
            "volume      8 mm^3\n"
            "area        24 mm^2\n"
            "box         x 9 to 11, y 19 to 21, z 29 to 31 mm\n"
            "components  1\n"
            "cavities    0\n");
  EXPECT_EQ(to_json(measures, "a \"cube\"", ""),
            R"({"model":"a \"cube\"","units":"","level":0,"exact":true,)"
            R"("volume":{"lower":8,"upper":8},"area":{"lower":24,"upper":24},)"
            R"("box":{"inner":{"lower":[9,19,29],"upper":[11,21,31]},)"
            R"("outer":{"lower":[9,19,29],"upper":[11,21,31]}},"components":1,"cavities":0})"
            "\n");
}

}  // namespace
}  // namespace spoctree
