// Surfaces of random trees, level by level: closed, without needless edges, and the boundary of
// exactly the pieces' material.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cstdlib>
#include <glm/geometric.hpp>

#include "common/tree/classify.hpp"
#include "common/tree/pieces.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/sample_trees.hpp"
#include "tests/support/surface_judge.hpp"

namespace spoctree {
namespace {

class PieceVolume : public PieceVisitor {
 public:
  void piece(const NodeAddress&, NodeKind, std::uint32_t, const Polyhedron& piece) override {
    sum += volume(piece);
  }
  double sum = 0;
};

double volume_of_pieces(const Octree& tree, std::uint32_t level) {
  PieceVolume pieces;
  WalkOptions options;
  options.level = level;
  walk_pieces(tree, options, pieces);
  return pieces.sum;
}

void judge_surface(const Octree& tree, std::uint32_t level, std::uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed) + " level " + std::to_string(level));
  const Surface surface = rebuild_surface(tree, level);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
  EXPECT_NEAR(volume(surface), volume_of_pieces(tree, level), 1e-9);
  const PolygonMesh mesh = make_polygon_mesh(surface, tree.universe);
  EXPECT_EQ(faults_of(mesh), std::vector<std::string>{});
  const double scale = tree.universe.scale();
  // Model coordinates are rounded as far from the origin as the model is.
  const double rounding = 1e-15 * glm::length(tree.universe.center) / scale;
  EXPECT_NEAR(volume_of(mesh) / (scale * scale * scale), volume(surface), 1e-9 + 100 * rounding);
  Random random(seed + 1000000);
  const double reach = tree.universe.half_side;
  for (int i = 0; i < 100; ++i) {
    const Vec3 point{random.between(-reach, reach), random.between(-reach, reach),
                     random.between(-reach, reach)};
    // T_level is at least what is known and at most what is not known to be empty.
    const PointClass known = classify_point(tree, point, level);
    const int winding = winding_number(surface, point);
    if (known == PointClass::Out) {
      EXPECT_EQ(winding, 0);
    } else if (known != PointClass::On) {
      EXPECT_EQ(winding, 1);
    }
  }
}

void judge_levels(const Octree& tree, std::uint64_t seed) {
  for (std::uint32_t level = 0; level < tree.levels.size(); ++level) {
    judge_surface(tree, level, seed);
  }
}

TEST(RebuildProperty, EveryLevelOfARandomTreeIsClosedAndBoundsItsPieces) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) judge_levels(random_tree(seed), seed);
}

TEST(RebuildProperty, EveryLevelOfALargeRandomTreeIsClosedAndBoundsItsPieces) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    judge_levels(random_tree(seed, {.levels = 6, .max_nodes = 4000, .grey_chance = 0.6}), seed);
  }
}

TEST(RebuildProperty, PlanesThroughCommonPointsLinesAndWallsMakeNoDifference) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) judge_levels(degenerate_tree(seed, 3), seed);
}

TEST(RebuildProperty, TheSameTreeGivesTheSameSurface) {
  const Octree tree = random_tree(7);
  const Surface one = rebuild_surface(tree);
  const Surface two = rebuild_surface(tree);
  EXPECT_EQ(to_off(make_polygon_mesh(one, tree.universe)),
            to_off(make_polygon_mesh(two, tree.universe)));
}

TEST(RebuildProperty, AnyNumberOfThreadsGivesTheSameBytes) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    // Large enough for many tasks.
    const Octree tree = random_tree(seed, {.levels = 8, .max_nodes = 20000, .grey_chance = 0.6});
    for (const std::uint32_t level : {5u, 7u}) {
      std::string one;
      for (const std::size_t threads : {1, 2, 8}) {
        const oneapi::tbb::global_control limit(
            oneapi::tbb::global_control::max_allowed_parallelism, threads);
        const Surface surface = rebuild_surface(tree, level);
        const std::string text = to_off(make_polygon_mesh(surface, tree.universe));
        if (one.empty()) one = text;
        EXPECT_TRUE(text == one) << threads << " threads";
      }
    }
  }
}

}  // namespace
}  // namespace spoctree
