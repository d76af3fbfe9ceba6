// What is drawn of random trees is what rays say is seen.
#include <gtest/gtest.h>

#include "client/lines/visible_lines.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/random.hpp"
#include "tests/support/sample_trees.hpp"
#include "tests/support/sight_oracle.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

Vec3 random_view(Random& random) {
  return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

Vec3 view_along_an_axis(Random& random) {
  Vec3 view{0.0};
  view[static_cast<int>(random.below(3))] = random.chance(0.5) ? 1 : -1;
  return view;
}

std::size_t expect_agreement(const Octree& tree, const Surface& surface, Vec3 view,
                             std::uint32_t level, const std::string& scene) {
  LineOptions options;
  options.level = level;
  const VisibleLines lines = visible_lines(tree, surface, Camera(view), options);
  const SightOracle oracle(surface, tree.plane_set(), view);
  std::size_t tried = 0;
  for (const std::string& error : compare(lines, oracle, 2, tried)) {
    ADD_FAILURE() << scene << ", level " << level << ", seen from (" << view.x << ", " << view.y
                  << ", " << view.z << "): " << error;
  }
  return tried;
}

TEST(VisibleLinesProperty, AgreeWithRaysOnRandomTreesAtEveryLevel) {
  std::size_t tried = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    RandomTreeOptions options;
    options.levels = 2 + random.below(3);
    options.max_nodes = 100 + random.below(300);
    options.max_planes_per_node = 4;
    const Octree tree = random_tree(seed, options);
    for (std::uint32_t level = 0; level < tree.levels.size(); ++level) {
      const Surface surface = rebuild_surface(tree, level);
      const std::string scene = "tree " + std::to_string(seed);
      tried += expect_agreement(tree, surface, random_view(random), level, scene);
      tried += expect_agreement(tree, surface, view_along_an_axis(random), level, scene);
    }
  }
  EXPECT_GT(tried, 10000u);
}

TEST(VisibleLinesProperty, AgreeWithRaysOnTreesFullOfCoincidences) {
  std::size_t tried = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const Octree tree = degenerate_tree(seed, 2 + random.below(3));
    const std::string scene = "degenerate tree " + std::to_string(seed);
    const auto level = random.below(static_cast<std::uint32_t>(tree.levels.size()));
    const Surface surface = rebuild_surface(tree, level);
    tried += expect_agreement(tree, surface, random_view(random), level, scene);
    tried += expect_agreement(tree, surface, view_along_an_axis(random), level, scene);
    if (tree.planes.empty()) continue;
    // Along some plane of the tree.
    const auto plane = random.below(static_cast<std::uint32_t>(tree.planes.size()));
    const Vec3 view = glm::cross(tree.planes[plane].normal, random_view(random));
    tried += expect_agreement(tree, surface, view, level, scene);
  }
  EXPECT_GT(tried, 10000u);
}

TEST(VisibleLinesProperty, AgreeWithRaysOnRandomCells) {
  std::size_t tried = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    std::vector<bool> cells(512);
    const double density = random.between(0.05, 0.7);
    for (std::size_t k = 0; k < cells.size(); ++k) cells[k] = random.chance(density);
    const Voxels voxels{3, [&](int x, int y, int z) {
                          return cells[static_cast<std::size_t>(64 * x + 8 * y + z)];
                        }};
    const Octree tree = tree_of(voxels);
    const std::string scene = "cells " + std::to_string(seed);
    const auto all = static_cast<std::uint32_t>(tree.levels.size() - 1);
    for (const Vec3 view :
         {random_view(random), view_along_an_axis(random), Vec3{1, -1, 0}, Vec3{1, 1, 1}}) {
      tried += expect_agreement(tree, surface_of(voxels), view, all, scene);
    }
    // The rebuilt surface has long edges and large faces instead.
    tried += expect_agreement(tree, rebuild_surface(tree), random_view(random), all, scene);
    tried += expect_agreement(tree, rebuild_surface(tree), view_along_an_axis(random), all, scene);
  }
  EXPECT_GT(tried, 10000u);
}

}  // namespace
}  // namespace spoctree
