// Surfaces of a tree that grows level by level: those of the whole tree, though what is settled is
// looked at once. Real meshes are those of the environment variable SPOCTREE_MESHES.
#include "client/rebuild/surface_rebuilder.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <filesystem>

#include "server/build/build_octree.hpp"
#include "server/mesh/read_mesh.hpp"
#include "server/solid/import_solid.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/meshes_folder.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

/// What a client has after level `level`.
Octree prefix_of(const Octree& tree, std::uint32_t level) {
  Octree prefix = tree;
  prefix.levels.resize(level + 1);
  std::uint32_t plane_count = 0;
  for (const Level& nodes : prefix.levels) {
    for (const std::uint32_t plane : nodes.references) {
      plane_count = std::max(plane_count, plane + 1);
    }
  }
  prefix.planes.resize(plane_count);
  return prefix;
}

/// Leaves and, of the last level, GREY nodes.
std::uint64_t count_leaves(const Octree& tree) {
  std::uint64_t leaves = tree.levels.back().grey_count;
  for (const Level& level : tree.levels) leaves += level.size() - level.grey_count;
  return leaves;
}

void expect_the_same_at_every_level(const Octree& tree) {
  SurfaceRebuilder rebuilder;
  std::uint64_t greys = 0;
  for (std::uint32_t level = 0; level < tree.levels.size(); ++level) {
    const Octree prefix = prefix_of(tree, level);
    const Surface grown = rebuilder.rebuild(prefix, level);
    EXPECT_TRUE(grown == rebuild_surface(prefix, level)) << "level " << level;
    // What comes later changes nothing.
    EXPECT_TRUE(grown == rebuild_surface(tree, level)) << "level " << level;
    // Leaves once, GREY nodes while they are the last ones.
    EXPECT_LE(rebuilder.cells_visited(), count_leaves(prefix) + greys) << "level " << level;
    greys += prefix.levels.back().grey_count;
  }
}

TEST(SurfaceRebuilder, GivesTheSurfacesOfRandomTrees) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_the_same_at_every_level(random_tree(seed));
  }
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    expect_the_same_at_every_level(
        random_tree(seed, {.levels = 8, .max_nodes = 8000, .grey_chance = 0.6}));
  }
}

TEST(SurfaceRebuilder, GivesTheSurfacesOfTreesFullOfCoincidences) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    expect_the_same_at_every_level(degenerate_tree(seed, 4));
  }
}

TEST(SurfaceRebuilder, MayPassOverLevelsAndComeToOneTwice) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const Octree tree = random_tree(seed, {.levels = 7, .max_nodes = 4000, .grey_chance = 0.6});
    const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
    SurfaceRebuilder rebuilder;
    for (const std::uint32_t level : {last / 3, last / 3, 2 * last / 3, last, last}) {
      EXPECT_TRUE(rebuilder.rebuild(tree, level) == rebuild_surface(tree, level));
    }
    const std::uint64_t visited = rebuilder.cells_visited();
    EXPECT_TRUE(rebuilder.rebuild(tree, static_cast<std::uint32_t>(-1)) == rebuild_surface(tree));
    EXPECT_EQ(rebuilder.cells_visited(), visited);
  }
}

TEST(SurfaceRebuilder, VisitsNoCellThatIsSettled) {
  // Of the eight nodes of every level but the first, seven are settled.
  Octree tree;
  tree.universe.half_side = 1;
  constexpr std::uint32_t kLevels = 12;
  tree.levels.resize(kLevels);
  tree.levels[0].append(NodeKind::Grey, {});
  for (std::uint32_t level = 1; level < kLevels; ++level) {
    const bool is_last = level + 1 == kLevels;
    tree.levels[level].append(is_last ? NodeKind::White : NodeKind::Grey, {});
    for (int octant = 1; octant < 8; ++octant) tree.levels[level].append(NodeKind::Black, {});
  }
  SurfaceRebuilder rebuilder;
  std::uint64_t visited = 0;
  for (std::uint32_t level = 0; level < kLevels; ++level) {
    EXPECT_TRUE(rebuilder.rebuild(tree, level) == rebuild_surface(tree, level));
    EXPECT_EQ(rebuilder.cells_visited() - visited, level == 0 ? 1u : 8u);
    visited = rebuilder.cells_visited();
  }
}

TEST(SurfaceRebuilder, GivesTheSameForAnyNumberOfThreads) {
  const Octree tree = random_tree(2, {.levels = 8, .max_nodes = 20000, .grey_chance = 0.6});
  std::vector<Surface> first;
  for (const std::size_t threads : {1, 2, 8}) {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                            threads);
    SurfaceRebuilder rebuilder;
    for (std::uint32_t level = 0; level < tree.levels.size(); ++level) {
      Surface surface = rebuilder.rebuild(tree, level);
      if (threads == 1) {
        first.push_back(std::move(surface));
      } else {
        EXPECT_TRUE(surface == first[level]) << threads << " threads, level " << level;
      }
    }
  }
}

class SurfaceRebuilderOnMeshes : public testing::TestWithParam<const char*> {};

TEST_P(SurfaceRebuilderOnMeshes, GivesTheirSurfaces) {
  const char* folder = meshes_folder();
  if (folder == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
  const Solid solid =
      import_solid(read_mesh(std::filesystem::path(folder) / GetParam()), GetParam(), {1e-12});
  expect_the_same_at_every_level(build_octree(solid, SolidQueries(solid), {}).tree);
}

INSTANTIATE_TEST_SUITE_P(Models, SurfaceRebuilderOnMeshes,
                         testing::Values("cad/hex-nut-M3_620f.stl", "cad/part_346f.off",
                                         "cad/anchor_1050f.off", "cad/cross_38quads.off",
                                         "cad/fandisk_12946f.off",
                                         "scan/stanford-bunny-filled_3996f.off"),
                         [](const auto& tested) { return test_name_of(tested.param); });

}  // namespace
}  // namespace spoctree
