#include "client/lines/extent.hpp"

#include <gtest/gtest.h>

#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

TEST(Extent, IsThatOfTheCoarsestSolid) {
  // The lower half of the universe: T_0 of a tree with a GREY root without planes is the cube.
  const Voxels half{1, [](int, int, int z) { return z == 0; }};
  const Camera camera(Vec3{0, -1, 0});
  const Rectangle extent = extent_of_solid(tree_of(half), camera);
  EXPECT_EQ(extent.lower, Vec2(-1, -1));
  EXPECT_EQ(extent.upper, Vec2(1, 1));
  // One CONVEX root: T_0 is the solid.
  Octree tree;
  tree.planes = {{{0, 0, 1}, 0.25}};
  Level level;
  const std::uint32_t planes[] = {0};
  level.append(NodeKind::Convex, planes);
  tree.levels.push_back(level);
  EXPECT_EQ(extent_of_solid(tree, camera).upper, Vec2(1, 0.25));
}

TEST(Extent, IsTheUniversesIfThereIsNoSolid) {
  const Voxels nothing{1, [](int, int, int) { return false; }};
  EXPECT_EQ(extent_of_solid(tree_of(nothing), Camera(Vec3{1, 0, 0})).upper, Vec2(1, 1));
}

}  // namespace
}  // namespace spoctree
