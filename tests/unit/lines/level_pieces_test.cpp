#include "client/rebuild/level_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "common/base/errors.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

/// Corners in an order of their own, to be compared.
std::vector<Vec3> sorted(std::span<const Vec3> corners) {
  std::vector<Vec3> result(corners.begin(), corners.end());
  const auto key = [](Vec3 p) { return p.x + 1.61803 * p.y + 2.23607 * p.z; };
  std::sort(result.begin(), result.end(), [&](Vec3 p, Vec3 q) { return key(p) < key(q); });
  return result;
}

void expect_same(const LevelPieces& p, const LevelPieces& q, const Octree& tree) {
  ASSERT_EQ(p.leaf_count(), q.leaf_count());
  for (std::uint32_t level = 0; level <= p.level(); ++level) {
    for (std::uint32_t index = 0; index < tree.levels[level].size(); ++index) {
      NodeAddress node;
      node.level = level;
      node.index = index;
      const LeafPieces* const a = p.find(node);
      const LeafPieces* const b = q.find(node);
      ASSERT_EQ(a == nullptr, b == nullptr) << "level " << level << ", node " << index;
      if (a == nullptr) continue;
      EXPECT_EQ(a->is_whole_cube, b->is_whole_cube);
      ASSERT_EQ(a->piece_count, b->piece_count);
      EXPECT_TRUE(std::ranges::equal(p.expression(*a), q.expression(*b)));
      std::vector<std::uint32_t> bounds[2] = {{p.bounds(*a).begin(), p.bounds(*a).end()},
                                              {q.bounds(*b).begin(), q.bounds(*b).end()}};
      for (auto& planes : bounds) std::sort(planes.begin(), planes.end());
      EXPECT_EQ(bounds[0], bounds[1]);
      for (std::uint32_t piece = 0; piece < a->piece_count; ++piece) {
        const std::vector<Vec3> corners = sorted(p.corners(*a, piece));
        const std::vector<Vec3> others = sorted(q.corners(*b, piece));
        ASSERT_EQ(corners.size(), others.size());
        for (std::size_t k = 0; k < corners.size(); ++k) {
          EXPECT_LT(glm::distance(corners[k], others[k]), 1e-9);
        }
      }
    }
  }
}

void expect_same_level_by_level(const Octree& tree) {
  LevelPieces growing(tree, 0);
  // All but the WHITE ones, each once.
  std::uint64_t nodes = 0;
  for (const Level& level : tree.levels) {
    nodes += level.size() - level.count_kinds()[static_cast<int>(NodeKind::White)];
  }
  for (std::uint32_t level = 0; level < tree.levels.size(); ++level) {
    if (level > 0) growing.go_on_to(tree, level);
    expect_same(growing, LevelPieces(tree, level), tree);
  }
  EXPECT_LE(growing.nodes_visited(), nodes);
}

TEST(LevelPieces, AreTheSameWhetherTheTreeHasGrownOrNot) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomTreeOptions options;
    options.levels = 4;
    options.max_nodes = 300;
    expect_same_level_by_level(random_tree(seed, options));
    expect_same_level_by_level(degenerate_tree(seed, 4));
  }
}

TEST(LevelPieces, BeginAnewAtAnyLevel) {
  const Octree tree = degenerate_tree(3, 4);
  LevelPieces pieces(tree, 2);
  pieces.go_on_to(tree, 0);
  expect_same(pieces, LevelPieces(tree, 0), tree);
  pieces.go_on_to(tree, 99);
  expect_same(pieces, LevelPieces(tree, 3), tree);
}

/// What making them complains of.
std::string complaint(const Octree& tree, std::uint32_t level, const PieceLimits& limits) {
  try {
    const LevelPieces pieces(tree, level, {}, limits);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(LevelPieces, RefuseMoreThanTheirLimits) {
  const Octree tree = random_tree(2, {.levels = 4, .max_nodes = 300});
  const std::size_t leaves = LevelPieces(tree, 3).leaf_count();
  ASSERT_GT(leaves, 1u);
  EXPECT_EQ(complaint(tree, 3, {}), "");
  EXPECT_EQ(complaint(tree, 3, {.leaves = leaves}), "");
  EXPECT_EQ(complaint(tree, 3, {.leaves = leaves - 1}),
            "more than " + std::to_string(leaves - 1) + " leaves with material");
  // No polyhedron has fewer than four corners.
  EXPECT_EQ(complaint(tree, 3, {.corners = 3}).substr(0, 27), "more than 3 corners of piec");
  EXPECT_NE(complaint(tree, 3, {.corners = 0}), "");
}

TEST(LevelPieces, RefuseMoreThanTheirLimitsWhenTheyGoOn) {
  const Octree tree = random_tree(2, {.levels = 4, .max_nodes = 300});
  const std::size_t leaves = LevelPieces(tree, 2).leaf_count();
  ASSERT_GT(LevelPieces(tree, 3).leaf_count(), leaves);
  LevelPieces pieces(tree, 2, {}, {.leaves = leaves});
  std::uint32_t level = 2;
  const auto go_on = [&] {
    while (++level < tree.levels.size()) pieces.go_on_to(tree, level);
  };
  EXPECT_THROW(go_on(), BadInput);
}

}  // namespace
}  // namespace spoctree
