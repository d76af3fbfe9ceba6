#include "client/queries/measure.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "client/queries/shells.hpp"
#include "client/rebuild/surface.hpp"
#include "common/tree/piece_bounds.hpp"
#include "tests/support/random.hpp"
#include "tests/support/sample_trees.hpp"
#include "tests/support/voxels.hpp"

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
  const auto shells = find_shells(rebuild_surface(shell), shell.plane_set(), Filling::Material);
  ASSERT_EQ(shells.size(), 2u);
  EXPECT_EQ(shells[0].face_count, 6u);
  EXPECT_NEAR(std::max(shells[0].volume, shells[1].volume), 8, 1e-14);
  EXPECT_NEAR(std::min(shells[0].volume, shells[1].volume), -1, 1e-14);
}

TEST(Measure, TakesWhatTouchesInEdgesForSeparateBodies) {
  const auto is_odd = [](int x, int y, int z) { return (x + y + z) % 2 == 1; };
  // A checkerboard of 32 cubes of side 1/2: every inner edge has two of them on it. Of the 8 inner
  // cells 4 are empty, behind 6 cubes each.
  Measures measures = measure(voxel_tree(is_odd), 2);
  EXPECT_EQ(measures.components, 32u);
  EXPECT_EQ(measures.cavities, 4u);
  EXPECT_NEAR(measures.volume.lower, 4, 1e-14);
  EXPECT_NEAR(measures.area.lower, 32 * 6.0 / 4, 1e-13);
  // The same rooms in a block.
  const auto is_inner = [](int v) { return v == 1 || v == 2; };
  measures = measure(voxel_tree([&](int x, int y, int z) {
                       return !(is_inner(x) && is_inner(y) && is_inner(z) && is_odd(x, y, z));
                     }),
                     2);
  EXPECT_EQ(measures.components, 1u);
  EXPECT_EQ(measures.cavities, 4u);
  EXPECT_NEAR(measures.volume.lower, 60.0 / 8, 1e-14);
}

/// Counts the face-connected parts of the cells of a grid for which `is_in` holds.
template <class IsIn>
unsigned count_parts(int side, IsIn&& is_in) {
  const auto number = [&](int x, int y, int z) {
    return static_cast<std::size_t>((z * side + y) * side + x);
  };
  std::vector<bool> done(number(0, 0, side));
  unsigned parts = 0;
  std::vector<std::array<int, 3>> open;
  const auto reach = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= side || y >= side || z >= side) return false;
    if (done[number(x, y, z)] || !is_in(x, y, z)) return false;
    done[number(x, y, z)] = true;
    open.push_back({x, y, z});
    return true;
  };
  for (int z = 0; z < side; ++z) {
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        if (!reach(x, y, z)) continue;
        ++parts;
        while (!open.empty()) {
          const auto [a, b, c] = open.back();
          open.pop_back();
          for (const int step : {-1, 1}) {
            reach(a + step, b, c);
            reach(a, b + step, c);
            reach(a, b, c + step);
          }
        }
      }
    }
  }
  return parts;
}

TEST(Measure, CountsThePartsOfRandomCells) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double density = random.between(0.2, 0.9);
    bool full[8][8][8];
    int count = 0;
    for (auto& plane : full) {
      for (auto& row : plane) {
        for (bool& cell : row) count += (cell = random.chance(density)) ? 1 : 0;
      }
    }
    const auto is_full = [&](int x, int y, int z) { return full[z][y][x]; };
    const Octree tree = tree_of({3, is_full});
    const Measures measures = measure(tree, static_cast<std::uint32_t>(tree.levels.size() - 1));
    EXPECT_EQ(measures.components, count_parts(8, is_full));
    // With a layer of emptiness around it, all that is outside is one part.
    const auto is_empty = [&](int x, int y, int z) {
      const auto is_edge = [](int v) { return v == 0 || v == 9; };
      return is_edge(x) || is_edge(y) || is_edge(z) || !full[z - 1][y - 1][x - 1];
    };
    EXPECT_EQ(measures.cavities, count_parts(10, is_empty) - 1);
    EXPECT_NEAR(measures.volume.lower, count / 64.0, 1e-12);
  }
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
