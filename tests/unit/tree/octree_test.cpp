// The tree's columns, and a broken tree for every invariant that `validate` names.
#include "common/tree/octree.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "common/tree/expression.hpp"
#include "common/tree/validate.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

using Tokens = std::vector<std::uint32_t>;

TEST(Level, LinksGreyNodesInOrderAndKeepsColumnsApart) {
  Level level;
  const std::uint32_t planes[] = {4, 2, 7};
  const std::uint32_t tokens[] = {kFirstPlaneToken, kInToken, kOutToken};
  level.append(NodeKind::Grey, std::span(planes).first(2));
  level.append(NodeKind::White, {});
  level.append(NodeKind::Grey, {});
  level.append(NodeKind::Vertex, planes, tokens);
  level.append(NodeKind::Grey, std::span(planes).first(1));
  EXPECT_EQ(level.size(), 5u);
  EXPECT_EQ(level.grey_count, 3u);
  EXPECT_EQ(level.first_child[0], 0u);
  EXPECT_EQ(level.first_child[2], 8u);
  EXPECT_EQ(level.first_child[4], 16u);
  EXPECT_EQ(level.planes_of(0).size(), 2u);
  EXPECT_EQ(level.planes_of(0)[1], 2u);
  EXPECT_TRUE(level.planes_of(1).empty());
  EXPECT_TRUE(level.planes_of(2).empty());
  EXPECT_EQ(level.planes_of(3).size(), 3u);
  EXPECT_EQ(level.planes_of(3)[2], 7u);
  EXPECT_EQ(level.planes_of(4)[0], 4u);
  EXPECT_TRUE(level.expression_of(0).empty());
  EXPECT_EQ(level.expression_of(3).size(), 3u);
  EXPECT_EQ(level.expression_of(3)[1], kInToken);
  EXPECT_TRUE(level.expression_of(4).empty());
  const std::array<std::uint32_t, kNodeKindCount> counts{1, 0, 3, 0, 0, 1};
  EXPECT_EQ(level.count_kinds(), counts);
}

TEST(Octree, SaysHowLargeTheNextLevelMustBe) {
  Octree tree;
  EXPECT_EQ(tree.next_level_size(), 1u);
  EXPECT_FALSE(tree.is_complete());
  tree.levels.emplace_back().append(NodeKind::Grey, {});
  EXPECT_EQ(tree.next_level_size(), 8u);
  EXPECT_FALSE(tree.is_complete());
  Level& second = tree.levels.emplace_back();
  for (int i = 0; i < 8; ++i) second.append(i < 3 ? NodeKind::Grey : NodeKind::Black, {});
  EXPECT_EQ(tree.next_level_size(), 24u);
  Level& third = tree.levels.emplace_back();
  for (int i = 0; i < 24; ++i) third.append(NodeKind::White, {});
  EXPECT_EQ(tree.next_level_size(), 0u);
  EXPECT_TRUE(tree.is_complete());
}

TEST(IsWellFormed, TakesExactlyOneExpression) {
  constexpr std::uint32_t kPlane = kFirstPlaneToken;
  EXPECT_TRUE(is_well_formed(Tokens{kInToken}, 0));
  EXPECT_TRUE(is_well_formed(Tokens{kOutToken}, 0));
  EXPECT_TRUE(is_well_formed(Tokens{kPlane, kInToken, kOutToken}, 1));
  EXPECT_TRUE(is_well_formed(
      Tokens{kPlane, kPlane + 1, kInToken, kOutToken, kPlane + 1, kOutToken, kInToken}, 2));
  EXPECT_FALSE(is_well_formed(Tokens{}, 3));
  EXPECT_FALSE(is_well_formed(Tokens{kInToken, kInToken}, 3));
  EXPECT_FALSE(is_well_formed(Tokens{kPlane}, 3));
  EXPECT_FALSE(is_well_formed(Tokens{kPlane, kInToken}, 3));
  EXPECT_FALSE(is_well_formed(Tokens{kPlane, kInToken, kInToken, kOutToken}, 3));
  EXPECT_FALSE(is_well_formed(Tokens{kPlane + 3, kInToken, kOutToken}, 3));
  EXPECT_FALSE(is_well_formed(Tokens{0xffffffffu, kInToken, kOutToken}, 3));
}

TEST(Expression, SkipsOneExpressionAndSpellsUnions) {
  constexpr std::uint32_t kPlane = kFirstPlaneToken;
  const Tokens tokens{kPlane, kPlane + 1, kInToken, kOutToken, kOutToken, kInToken};
  EXPECT_EQ(skip_expression(tokens.data()), tokens.data() + 5);
  EXPECT_EQ(skip_expression(tokens.data() + 1), tokens.data() + 4);
  EXPECT_EQ(skip_expression(tokens.data() + 2), tokens.data() + 3);
  EXPECT_EQ(union_of(2), (Tokens{kPlane, kInToken, kPlane + 1, kInToken, kOutToken}));
  EXPECT_TRUE(is_well_formed(union_of(7), 7));
}

TEST(Validate, FindsNothingInValidTrees) {
  EXPECT_TRUE(validate(Octree{}).empty());
  EXPECT_TRUE(validate(cube_tree()).empty());
  EXPECT_TRUE(validate(every_kind_tree()).empty());
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Octree tree = random_tree(seed);
    EXPECT_TRUE(validate(tree).empty());
    EXPECT_TRUE(validate(degenerate_tree(seed, 5)).empty());
    // A prefix of a tree is a tree, but for the planes that the lost levels brought.
    tree.levels.resize(1);
    std::uint32_t planes = 0;
    for (const std::uint32_t plane : tree.levels[0].references)
      planes = std::max(planes, plane + 1);
    tree.planes.resize(planes);
    EXPECT_TRUE(validate(tree).empty());
  }
}

/// What validate says of the tree with one of each kind (see sample_trees.hpp) after a change.
std::vector<std::string> findings_after(const std::function<void(Octree&)>& change) {
  Octree tree = every_kind_tree();
  EXPECT_TRUE(validate(tree).empty());
  change(tree);
  return validate(tree);
}

#define EXPECT_FOUND(text, ...)                                                            \
  do {                                                                                     \
    const auto found = findings_after([]([[maybe_unused]] Octree& tree) { __VA_ARGS__; }); \
    ASSERT_FALSE(found.empty());                                                           \
    EXPECT_NE(found.front().find(text), std::string::npos) << found.front();               \
  } while (false)

TEST(Validate, FindsAnInvalidUniverse) {
  EXPECT_FOUND("universe", tree.universe.half_side = 0.25);
  EXPECT_FOUND("universe", tree.universe.center.y = std::numeric_limits<double>::infinity());
}

TEST(Validate, FindsAnInvalidPlane) {
  EXPECT_FOUND("plane 3", tree.planes[3].normal = Vec3(0.5));
  EXPECT_FOUND("plane 7", tree.planes[7].offset = 0x1p-60);
  EXPECT_FOUND("plane 0", tree.planes[0].offset = std::numeric_limits<double>::quiet_NaN());
}

TEST(Validate, FindsAPlaneThatNoNodeRefersTo) {
  EXPECT_FOUND("1 planes that no node refers to", tree.planes.push_back(tree.planes[0]));
}

TEST(Validate, FindsLevelsOfTheWrongSize) {
  EXPECT_FOUND("level 1: 9 nodes where 8", tree.levels[1].append(NodeKind::Black, {}));
  EXPECT_FOUND("level 2: 9 nodes where 8", tree.levels[2].append(NodeKind::Black, {}));
  EXPECT_FOUND("level 0: 2 nodes where 1", tree.levels[0].append(NodeKind::Black, {}));
  EXPECT_FOUND("level 3: 1 nodes where 0", tree.levels.emplace_back().append(NodeKind::Black, {}));
  EXPECT_FOUND("level 2: 0 nodes where 8", tree.levels[2] = Level());
}

TEST(Validate, FindsAnEmptyLevelAfterTheLast) {
  EXPECT_FOUND("level 3: no nodes", tree.levels.emplace_back());
}

TEST(Validate, FindsTooManyLevelsHoweverManyThereAre) {
  Octree tree;
  tree.levels.emplace_back().append(NodeKind::Grey, {});
  Level level;
  level.append(NodeKind::Grey, {});
  for (int i = 0; i < 7; ++i) level.append(NodeKind::White, {});
  while (tree.levels.size() < kMaxDepth + 1) tree.levels.push_back(level);
  EXPECT_TRUE(validate(tree).empty());
  tree.levels.push_back(level);
  ASSERT_EQ(validate(tree).size(), 1u);
  EXPECT_NE(validate(tree).front().find("more than 31 levels"), std::string::npos);
  tree.levels.resize(100'000, level);  // deeper than a stack
  EXPECT_EQ(validate(tree).size(), 1u);
}

TEST(Validate, FindsStatementsThatAreNone) {
  EXPECT_FOUND("level 1: an error bound", tree.levels[1].statement.error_bound = -1);
  EXPECT_FOUND("level 0: an error bound",
               tree.levels[0].statement.inner_volume = std::numeric_limits<double>::quiet_NaN());
  EXPECT_FOUND("level 2: an error bound",
               tree.levels[2].statement.outer_volume = std::numeric_limits<double>::infinity());
  EXPECT_FOUND("level 2: an error bound", tree.levels[2].statement.outer_volume = 7.5);
  EXPECT_FOUND("level 1: an error bound", tree.levels[1].statement.inner_area = 25.5);
}

TEST(Validate, FindsColumnsThatDoNotMatch) {
  EXPECT_FOUND("level 1: columns", tree.levels[1].first_child.pop_back());
  EXPECT_FOUND("level 1: columns", tree.levels[1].reference_begin.pop_back());
  EXPECT_FOUND("level 1: columns", tree.levels[1].reference_begin.clear());
  EXPECT_FOUND("level 1: columns", tree.levels[1].token_begin.clear());
  EXPECT_FOUND("level 1: columns", tree.levels[1].token_begin.push_back(7));
  EXPECT_FOUND("level 1: columns", tree.levels[1].references.push_back(0));
  EXPECT_FOUND("level 1: columns", tree.levels[1].tokens.pop_back());
  EXPECT_FOUND("level 1: columns", tree.levels[1].reference_begin[0] = 1);
  EXPECT_FOUND("level 1: columns", tree.levels[1].reference_begin[3] = 0xffffffffu);
  EXPECT_FOUND("level 1: columns",
               std::swap(tree.levels[1].reference_begin[2], tree.levels[1].reference_begin[3]));
}

TEST(Validate, FindsUnknownKinds) {
  EXPECT_FOUND("level 1 node 5: an unknown kind", tree.levels[1].kinds[5] = NodeKind{6});
  EXPECT_FOUND("level 1 node 5: an unknown kind", tree.levels[1].kinds[5] = NodeKind{255});
}

TEST(Validate, FindsPlaneCountsThatDoNotFitTheKind) {
  EXPECT_FOUND("level 1 node 1: a homogeneous node has planes",
               tree.levels[1].kinds[1] = NodeKind::White);
  EXPECT_FOUND("level 1 node 1: a homogeneous node has planes",
               tree.levels[1].kinds[1] = NodeKind::Black);
  EXPECT_FOUND("level 1 node 5: a convex node without planes",
               tree.levels[1].kinds[5] = NodeKind::Convex);
  EXPECT_FOUND("level 1 node 1: a concave node with fewer than 2",
               tree.levels[1].kinds[1] = NodeKind::Concave);
  EXPECT_FOUND("level 1 node 5: a vertex node without planes",
               tree.levels[1].kinds[5] = NodeKind::Vertex);
}

TEST(Validate, FindsReferencesOutOfRangeOrOrder) {
  EXPECT_FOUND("level 2 node 7: plane 8 is not", tree.levels[2].references.back() = 8);
  EXPECT_FOUND("level 0 node 0: plane 1 is not", tree.levels[0].references[0] = 1);
  EXPECT_FOUND("level 2 node 7: plane 4294967295", tree.levels[2].references.back() = 0xffffffffu);
  // Planes 6 and 7 appear the other way round.
  EXPECT_FOUND("level 2 node 6: plane 7 is not", tree.levels[2].references[0] = 7);
}

TEST(Validate, FindsAPlaneTwiceInANode) {
  EXPECT_FOUND("level 2 node 7: plane 6 is repeated", tree.levels[2].references.back() = 6);
}

TEST(Validate, FindsAPlaneOfAnAncestorInANode) {
  EXPECT_FOUND("level 1 node 4: plane 0 is repeated",
               tree.levels[1].references[tree.levels[1].reference_begin[4] + 1] = 0);
  EXPECT_FOUND("level 2 node 7: plane 0 is repeated", tree.levels[2].references.back() = 0);
}

TEST(Validate, FindsMalformedExpressions) {
  EXPECT_FOUND("level 1 node 4: a malformed", tree.levels[1].tokens.front() = kInToken);
  EXPECT_FOUND("level 1 node 4: a malformed", tree.levels[1].tokens.back() = kFirstPlaneToken);
  EXPECT_FOUND("level 1 node 4: a malformed", tree.levels[1].tokens[0] = kFirstPlaneToken + 3);
  // An expression in a node that is no VERTEX node.
  EXPECT_FOUND("level 2 node 7: a malformed", tree.levels[2].tokens.push_back(kInToken);
               tree.levels[2].token_begin.back() = 1);
}

TEST(Validate, FindsWrongLinksAndCounts) {
  EXPECT_FOUND("level 1 node 3: a wrong link", tree.levels[1].first_child[3] = 8);
  EXPECT_FOUND("level 0 node 0: a wrong link", tree.levels[0].first_child[0] = 0xffffff00u);
  EXPECT_FOUND("level 1: a wrong count of GREY", tree.levels[1].grey_count = 2);
}

TEST(Validate, NamesNoMoreThanTheLimit) {
  Octree tree = every_kind_tree();
  for (Plane& plane : tree.planes) plane.offset = 5;
  EXPECT_EQ(validate(tree).size(), 8u);
  EXPECT_EQ(validate(tree, 3).size(), 3u);
}

}  // namespace
}  // namespace spoctree
