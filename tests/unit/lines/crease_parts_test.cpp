#include "client/lines/crease_parts.hpp"

#include <gtest/gtest.h>

#include "common/base/errors.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

constexpr double kTolerance = 1e-10;

/// A tree that is divided into 64 cells: every other one is material.
Octree chequered() {
  return tree_of({2, [](int x, int y, int z) { return (x + y + z) % 2 == 0; }});
}

/// The lengths of the parts in all leaves, summed up.
double length_of_parts(const Octree& tree, const Crease& crease) {
  const CreaseParts parts(tree, 9, {&crease, 1}, kTolerance);
  double sum = 0;
  for (std::uint32_t level = 0; level < tree.levels.size(); ++level) {
    for (std::uint32_t k = 0; k < tree.levels[level].kinds.size(); ++k) {
      if (tree.levels[level].kinds[k] == NodeKind::Grey) continue;
      for (const CreasePart& part : parts.of({level, k})) {
        sum += (part.interval.end - part.interval.begin) * glm::distance(crease.a, crease.b);
      }
    }
  }
  return sum;
}

TEST(CreaseParts, DivideACreaseAmongTheLeavesThatItRunsThrough) {
  const Octree tree = chequered();
  const Crease crease{{-0.93, -0.81, -0.77}, {0.91, 0.74, 0.83}};
  EXPECT_NEAR(length_of_parts(tree, crease), glm::distance(crease.a, crease.b), 1e-8);
}

TEST(CreaseParts, AreInAllLeavesAroundAnEdgeOfTheCells) {
  const Octree tree = chequered();
  const double half = tree.universe.half_side;
  // On a wall, two leaves touch; on an edge of cells, four.
  EXPECT_NEAR(length_of_parts(tree, {{0.1, 0.2, 0}, {0.3, 0.2, 0}}), 2 * 0.2, 1e-8);
  EXPECT_NEAR(length_of_parts(tree, {{-half, 0, 0}, {half, 0, 0}}), 4 * 2 * half, 1e-8);
}

TEST(CreaseParts, StandWithTheNodesOfTheLevelLookedAt) {
  const Octree tree = chequered();
  const Crease crease{{-0.93, -0.81, -0.77}, {0.91, 0.74, 0.83}};
  const CreaseParts parts(tree, 0, {&crease, 1}, kTolerance);
  ASSERT_EQ(parts.of({}).size(), 1u);
  EXPECT_EQ(parts.of({})[0].interval.begin, 0);
  EXPECT_EQ(parts.of({})[0].interval.end, 1);
}

TEST(CreaseParts, RefuseToBeMoreThanTheirLimit) {
  const Octree tree = chequered();
  // Along an edge of cells, 4 leaves touch each of 4 parts.
  const Crease crease{{-tree.universe.half_side, 0, 0}, {tree.universe.half_side, 0, 0}};
  EXPECT_NO_THROW(CreaseParts(tree, 9, {&crease, 1}, kTolerance, {}, 16));
  try {
    CreaseParts(tree, 9, {&crease, 1}, kTolerance, {}, 15);
    FAIL() << "too many are taken";
  } catch (const BadInput& error) {
    EXPECT_STREQ(error.what(), "more than 15 parts of creases");
  }
}

}  // namespace
}  // namespace spoctree
