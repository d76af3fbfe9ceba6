// Surfaces of random trees, level by level: closed, without needless edges, and the boundary of
// exactly the pieces' material.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <map>

#include "common/tree/classify.hpp"
#include "common/tree/pieces.hpp"
#include "common/tree/validate.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/grid_planes.hpp"
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

/// Edges that do not run as often one way as the other.
std::size_t count_open_edges(const Surface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const Surface::Loop& loop : surface.loops) {
    const auto vertices = surface.vertices_of(loop);
    std::uint32_t from = vertices.back();
    for (const std::uint32_t to : vertices) {
      balance[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
      from = to;
    }
  }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& e) { return e.second != 0; }));
}

/// Appends a random expression over planes 0 .. `plane_count` - 1.
void draw_expression(Random& random, std::uint32_t plane_count, int depth,
                     std::vector<std::uint32_t>& tokens) {
  if (depth == 0) {
    tokens.push_back(random.chance(0.5) ? kInToken : kOutToken);
    return;
  }
  tokens.push_back(kFirstPlaneToken + random.below(plane_count));
  draw_expression(random, plane_count, depth - 1, tokens);
  draw_expression(random, plane_count, depth - 1, tokens);
}

/// Eight cells, each divided by many planes that are all within `tilt` of one of three.
Octree nearly_parallel_tree(std::uint64_t seed, double tilt) {
  Random random(seed);
  Octree tree;
  std::vector<Plane> bundle;
  for (int i = 0; i < 3; ++i) {
    bundle.push_back(random_degenerate_plane(random, Vec3{0.0}, 1, bundle));
  }
  constexpr std::uint32_t kPlanes = 16;
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < kPlanes; ++i) {
    const Plane& near = bundle[random.below(3)];
    const Vec3 turned = near.normal + random_vector(random, tilt);
    const Vec3 through = near.normal * near.offset + random_vector(random, tilt);
    tree.planes.push_back(grid_plane_through(random.chance(0.5) ? turned : -turned, through));
    all.push_back(i);
  }
  tree.levels.resize(2);
  tree.levels[0].append(NodeKind::Grey, {});
  for (int octant = 0; octant < 8; ++octant) {
    std::vector<std::uint32_t> tokens;
    draw_expression(random, kPlanes, 7, tokens);
    tree.levels[1].append(NodeKind::Vertex, all, tokens);
  }
  return tree;
}

TEST(RebuildProperty, IsClosedWherePlanesAreNearlyParallel) {
  for (int exponent = 6; exponent <= 13; ++exponent) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " tilt 1e-" + std::to_string(exponent));
      const Octree tree = nearly_parallel_tree(seed, std::pow(10, -exponent));
      ASSERT_EQ(validate(tree), std::vector<std::string>{});
      const Surface surface = rebuild_surface(tree);
      EXPECT_EQ(count_open_edges(surface), 0u);
      // Edges do not pile up in clusters of vertices: on average, not one face for every plane.
      EXPECT_LE(surface.sides.size(), tree.planes.size() * surface.edges.size());
      EXPECT_NEAR(volume(surface), volume_of_pieces(tree, 1), 1e-8);
    }
  }
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
