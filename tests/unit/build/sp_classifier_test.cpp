// Which kind a cell becomes, with which planes: solids whose trees are known by thinking.
#include "server/build/sp_classifier.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/tree/validate.hpp"
#include "server/build/build_octree.hpp"
#include "tests/unit/build/cells.hpp"

namespace spoctree {
namespace {

Octree tree_of(const Solid& solid, const SpRules& rules = kPaperRules) {
  const SolidQueries queries(solid);
  BuildOptions options;
  options.rules = rules;
  BuiltOctree built = build_octree(solid, queries, options);
  EXPECT_EQ(validate(built.tree), std::vector<std::string>{});
  EXPECT_TRUE(built.tree.is_complete());
  return std::move(built.tree);
}

/// Kinds of one level as W, B, G, C (convex), U (a union: concave), V, in octant order.
std::string kinds_of(const Octree& tree, std::size_t level) {
  std::string text;
  for (const NodeKind kind : tree.levels.at(level).kinds) {
    text += "WBGCUV"[static_cast<std::size_t>(kind)];
  }
  return text;
}

std::size_t plane_count(const Octree& tree, std::size_t level, std::uint32_t node) {
  return tree.levels.at(level).planes_of(node).size();
}

TEST(SpClassifier, ABoxIsOneConvexNodeWithSixPlanes) {
  const Octree tree = tree_of(box_solid(Vec3(-0.3), Vec3(0.6, 0.5, 0.4)));
  EXPECT_EQ(kinds_of(tree, 0), "C");
  EXPECT_EQ(plane_count(tree, 0, 0), 6u);
  EXPECT_EQ(tree.planes.size(), 6u);
}

TEST(SpClassifier, ABoxThatFillsTheUniverseIsStillOneConvexNode) {
  const Octree tree = tree_of(box_solid(Vec3(-1), Vec3(1)));
  EXPECT_EQ(kinds_of(tree, 0), "C");
  EXPECT_EQ(plane_count(tree, 0, 0), 6u);
}

// The cavity's planes face away from each other: outside each of them lies the rest of the cavity.
TEST(SpClassifier, ACavityWithinOneCellIsConcaveWithSixPlanes) {
  const Octree tree =
      tree_of(together(box_solid(Vec3(-0.9), Vec3(0.9)), turned(box_solid(Vec3(0.2), Vec3(0.7)))));
  EXPECT_EQ(kinds_of(tree, 0), "G");
  EXPECT_EQ(plane_count(tree, 0, 0), 6u) << "the outer box is the hull";
  EXPECT_EQ(kinds_of(tree, 1), "BBBBBBBU");
  EXPECT_EQ(plane_count(tree, 1, 7), 6u);
}

TEST(SpClassifier, ACavityInTheMiddleGivesEveryCellAConcaveCornerOfThree) {
  const Octree tree =
      tree_of(together(box_solid(Vec3(-0.9), Vec3(0.9)), turned(box_solid(Vec3(-0.3), Vec3(0.4)))));
  EXPECT_EQ(kinds_of(tree, 1), "UUUUUUUU");
  for (std::uint32_t node = 0; node < 8; ++node) EXPECT_EQ(plane_count(tree, 1, node), 3u);
  EXPECT_EQ(tree.planes.size(), 12u);
}

// An L of three of the four quarters of a block, its concave edge exactly on walls.
Solid l_of_quarters() {
  return voxel_solid({1, [](int x, int y, int) { return x + y < 2; }});
}

TEST(SpClassifier, AnLWhoseConcaveEdgeLiesInWallsNeedsNoConcaveNode) {
  const Octree tree = tree_of(l_of_quarters());
  EXPECT_EQ(kinds_of(tree, 0), "G");
  EXPECT_EQ(plane_count(tree, 0, 0), 6u);
  for (const std::uint32_t octant : {3u, 7u}) {
    EXPECT_EQ(tree.levels[1].kinds[octant], NodeKind::White);
  }
  for (const std::uint32_t octant : {0u, 4u}) {
    EXPECT_EQ(tree.levels[1].kinds[octant], NodeKind::Black);
  }
  for (const std::uint32_t octant : {1u, 2u, 5u, 6u}) {
    EXPECT_EQ(tree.levels[1].kinds[octant], NodeKind::Convex) << "the inner walls bound it";
    EXPECT_EQ(plane_count(tree, 1, octant), 1u);
  }
}

TEST(SpClassifier, AConcaveEdgeWithinACellIsConcaveWithTwoPlanes) {
  // The same L, moved off the walls.
  Solid moved = l_of_quarters();
  std::vector<Vec3> points = moved.vertices;
  for (Vec3& p : points) p = p * 0.5 + Vec3(0.125, 0.125, 0);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const SolidTriangle& t : moved.triangles) {
    triangles.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
  }
  const Octree tree = tree_of(hand_solid(points, triangles));
  EXPECT_EQ(kinds_of(tree, 0), "G");
  EXPECT_EQ(plane_count(tree, 0, 0), 6u);
  EXPECT_EQ(kinds_of(tree, 1), "BBBUBBBU");
  EXPECT_EQ(plane_count(tree, 1, 3), 2u);
}

// Heights around the middle that are above and below it by turns: a saddle vertex, not on a wall.
HeightField saddle_field() {
  return {2, Vec3(-0.75, -0.7, -0.75), 0.8, {0.5, 0.25, 0, 0.25, 0.25, 0.25, 0, 0.25, 0.5}};
}

TEST(SpClassifier, ASaddleVertexNeedsAVertexNode) {
  const HeightField field = saddle_field();
  const Solid solid = height_field_solid(field);
  const Octree tree = tree_of(solid);
  std::size_t vertex_nodes = 0;
  for (const Level& level : tree.levels) {
    for (std::uint32_t node = 0; node < level.size(); ++node) {
      if (level.kinds[node] != NodeKind::Vertex) continue;
      ++vertex_nodes;
      EXPECT_GE(level.planes_of(node).size(), 3u);
    }
  }
  EXPECT_GT(vertex_nodes, 0u);
}

// Two wedges of different bend that share a vertex, which lies in another cell: the rule that asks
// for the vertex in the cell would never end there.
TEST(SpClassifier, TheSharedVertexNeedNotLieInTheCell) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Octree tree = tree_of(uneven_solid(2, random));
    EXPECT_LT(tree.levels.size(), 20u);
  }
}

TEST(SpClassifier, LeafPlanesMakeLeavesOfCellsWithFewPlanes) {
  const Solid solid = height_field_solid(saddle_field());
  SpRules rules;
  rules.leaf_planes = 1000;
  const Octree tree = tree_of(solid, rules);
  EXPECT_EQ(kinds_of(tree, 0), "V");
  EXPECT_LE(plane_count(tree, 0, 0), solid.planes.size());
  Random random(5);
  const Solid large = uneven_solid(6, random);
  std::size_t before = static_cast<std::size_t>(-1);
  for (const std::uint32_t leaf_planes : {0u, 4u, 8u, 16u, 32u}) {
    rules.leaf_planes = leaf_planes;
    const Octree with = tree_of(large, rules);
    std::size_t nodes = 0;
    for (const Level& level : with.levels) nodes += level.size();
    EXPECT_LE(nodes, before) << leaf_planes;
    before = nodes;
  }
}

TEST(SpClassifier, MaxDepthEndsTheTreeAndCountsTheNodesItEnded) {
  Random random(6);
  const Solid solid = uneven_solid(6, random);
  const SolidQueries queries(solid);
  BuildOptions options;
  options.rules = kPaperRules;
  const BuiltOctree whole = build_octree(solid, queries, options);
  EXPECT_EQ(whole.depth_limited_nodes, 0u);
  for (std::uint32_t depth = 0; depth + 1 < whole.tree.levels.size(); ++depth) {
    options.rules = SpRules{0, depth};
    const BuiltOctree cut = build_octree(solid, queries, options);
    EXPECT_EQ(validate(cut.tree), std::vector<std::string>{});
    ASSERT_EQ(cut.tree.levels.size(), depth + 1);
    EXPECT_TRUE(cut.tree.is_complete());
    // Exactly the GREY nodes of the whole tree at this depth are VERTEX nodes here.
    EXPECT_EQ(cut.depth_limited_nodes, whole.tree.levels[depth].grey_count);
    for (std::uint32_t node = 0; node < cut.tree.levels[depth].size(); ++node) {
      const NodeKind kind = whole.tree.levels[depth].kinds[node];
      EXPECT_EQ(cut.tree.levels[depth].kinds[node],
                kind == NodeKind::Grey ? NodeKind::Vertex : kind);
    }
  }
}

}  // namespace
}  // namespace spoctree
