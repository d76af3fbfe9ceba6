// A tree that would never end is refused, whatever the number of threads.
#include <gtest/gtest.h>

#include <cmath>

#include "common/base/errors.hpp"
#include "server/build/build_octree.hpp"
#include "server/solid/import_solid.hpp"
#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;

// A thin plate between two boxes, 10^-6 apart from both and as thick, turned out of the axes: where
// all three are near, four planes are, and nothing joins them.
Solid plate_between_boxes(double gap) {
  PolygonSoup soup =
      together(together(box({0, 0, -1}, {1, 1, 0}), box({0, 0, gap}, {1, 1, 2 * gap})),
               box({0, 0, 3 * gap}, {1, 1, 1}));
  for (glm::dvec3& p : soup.points) p = {p.x + 0.3 * p.z, p.y - 0.2 * p.z, p.z + 0.1 * p.x};
  return import_solid(soup, "plate", {.flat_tolerance = 0});
}

/// By the default rule it would be small.
BuildOptions paper_options() {
  BuildOptions options;
  options.rules = kPaperRules;
  return options;
}

std::size_t node_count(const Octree& tree) {
  std::size_t count = 0;
  for (const Level& level : tree.levels) count += level.size();
  return count;
}

TEST(NodeBudget, RefusesATreeThatWouldNotEnd) {
  const Solid solid = plate_between_boxes(1e-6);
  const SolidQueries queries(solid);
  try {
    build_octree(solid, queries, paper_options());
    FAIL() << "was built";
  } catch (const BadInput& error) {
    EXPECT_EQ(std::string(error.what())
                  .find("the tree would have more than " +
                        std::to_string(kMostNodes + 36 * kMostNodesPerTriangle) + " nodes: "),
              0u)
        << error.what();
  }
}

TEST(NodeBudget, LeavesRoomForThinGaps) {
  const Solid solid = plate_between_boxes(1e-2);
  const SolidQueries queries(solid);
  EXPECT_GT(node_count(build_octree(solid, queries, paper_options()).tree), 1000u);
}

TEST(NodeBudget, IsEnoughWithALimitOfDepth) {
  const Solid solid = plate_between_boxes(1e-6);
  const SolidQueries queries(solid);
  BuildOptions options;
  options.rules = SpRules{0, 8};
  EXPECT_GT(build_octree(solid, queries, options).depth_limited_nodes, 1000u);
}

}  // namespace
}  // namespace spoctree
