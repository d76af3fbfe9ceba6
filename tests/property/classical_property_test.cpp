// Classical octrees, judged by the definition: every cell by rational numbers, every level by what
// it promises.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "client/rebuild/polygon_mesh.hpp"
#include "client/rebuild/surface.hpp"
#include "common/base/errors.hpp"
#include "common/tree/classify.hpp"
#include "common/tree/pieces.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/encode.hpp"
#include "server/build/certify.hpp"
#include "tests/support/cell_oracle.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/hand_solid.hpp"
#include "tests/support/model_solid.hpp"
#include "tests/support/solid_mesh.hpp"
#include "tests/unit/build/cells.hpp"

namespace spoctree {
namespace {

constexpr PartialCells kAllPartials[] = {PartialCells::Full, PartialCells::Void,
                                         PartialCells::Half};

/// Throws BadInput where nothing is left.
BuiltOctree classical(const Solid& solid, int depth, PartialCells partial) {
  const SolidQueries queries(solid);
  BuildOptions options;
  options.rules = ClassicalRules{static_cast<std::uint32_t>(depth), partial};
  BuiltOctree built = build_octree(solid, queries, options);
  certify(built, solid, queries);
  return built;
}

/// True for each cell of a depth that is full in the tree, by z, y, x.
std::vector<bool> full_cells(const Octree& tree, int depth) {
  const int count = 1 << depth;
  std::vector<bool> full;
  for (int z = 0; z < count; ++z) {
    for (int y = 0; y < count; ++y) {
      for (int x = 0; x < count; ++x) {
        std::uint32_t node = 0;
        std::size_t k = 0;
        for (int bit = depth - 1; tree.levels[k].kinds[node] == NodeKind::Grey; ++k, --bit) {
          const int octant = ((x >> bit) & 1) | ((y >> bit) & 1) << 1 | ((z >> bit) & 1) << 2;
          node = tree.levels[k].first_child[node] + static_cast<std::uint32_t>(octant);
        }
        full.push_back(tree.levels[k].kinds[node] == NodeKind::Black);
      }
    }
  }
  return full;
}

/// No tree has the same cells in fewer nodes.
void expect_merged(const Octree& tree) {
  for (std::size_t k = 0; k + 1 < tree.levels.size(); ++k) {
    const Level& level = tree.levels[k];
    for (std::uint32_t node = 0; node < level.size(); ++node) {
      if (level.kinds[node] != NodeKind::Grey) continue;
      const auto first = tree.levels[k + 1].kinds.begin() + level.first_child[node];
      const bool is_one_colour =
          *first != NodeKind::Grey &&
          std::all_of(first, first + 8, [&](auto k2) { return k2 == *first; });
      EXPECT_FALSE(is_one_colour) << "level " << k << ", node " << node;
    }
  }
}

/// Every cell of the depth limit is what the definition says, for each --partial. `is_inside` is
/// for the centres of mixed cells.
void judge_cells(const Solid& solid, int depth, const std::function<bool(Vec3)>& is_inside) {
  using Cell = CellOracle::Cell;
  const CellOracle oracle(solid);
  const std::vector<Cell> cells = oracle.cells(depth);
  const int count = 1 << depth;
  const double side = 2 * solid.universe.half_side / count;
  for (const PartialCells partial : kAllPartials) {
    SCOPED_TRACE(testing::Message() << "partial " << static_cast<int>(partial));
    std::vector<bool> expected;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      bool is_full = cells[i] == Cell::Full || partial == PartialCells::Full;
      if (cells[i] == Cell::Mixed && partial == PartialCells::Half) {
        const auto index = static_cast<int>(i);
        const Vec3 place(index % count, index / count % count, index / count / count);
        is_full = is_inside((place + 0.5) * side - solid.universe.half_side);
      }
      expected.push_back(is_full && cells[i] != Cell::Void);
    }
    if (std::none_of(expected.begin(), expected.end(), [](bool full) { return full; })) {
      EXPECT_THROW(classical(solid, depth, partial), BadInput);
      continue;
    }
    const Octree tree = classical(solid, depth, partial).tree;
    EXPECT_EQ(validate(tree), std::vector<std::string>{});
    EXPECT_LE(tree.levels.size(), static_cast<std::size_t>(depth) + 1);
    EXPECT_TRUE(tree.planes.empty());
    const std::vector<bool> found = full_cells(tree, depth);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) wrong += found[i] != expected[i];
    EXPECT_EQ(wrong, 0u) << "cells of " << cells.size();
    expect_merged(tree);
  }
}

void judge_cells(const Solid& solid, int depth) {
  const MeshJudge judge(universe_mesh_of(solid));
  judge_cells(solid, depth, [&](Vec3 point) { return judge.is_inside(point); });
}

TEST(Classical, CellsOfModelsAreWhatTheDefinitionSays) {
  for (const char* name : {"mechanical-piece", "l-bracket", "double-torus", "nested-boxes",
                           "two-parts", "saddle", "diamond", "pyramid"}) {
    for (const int depth : {1, 4}) {
      SCOPED_TRACE(testing::Message() << name << ", depth " << depth);
      judge_cells(model_solid(name), depth);
    }
  }
  judge_cells(model_solid("sphere", 8), 5);
  judge_cells(model_solid("cone", 20), 4);
  judge_cells(model_solid("self-occluding", 12), 4);
}

TEST(Classical, CellsOfRandomSurfacesAreWhatTheDefinitionSays) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    judge_cells(uneven_solid(5, random), 3);
  }
}

TEST(Classical, CellsBesideFacesInWallsAreNotMixed) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Voxels voxels = random_voxels(2, random);
    const Solid solid = voxel_solid(voxels);
    const auto is_inside = [&](Vec3 p) {
      const Vec3 cell = glm::floor((p + 1.0) * 2.0);
      return voxels(static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z));
    };
    for (const int depth : {2, 3}) {
      judge_cells(solid, depth, is_inside);
      // All faces are in walls, so the voxels are the tree, and it is exact.
      for (const PartialCells partial : kAllPartials) {
        const BuiltOctree built = classical(solid, depth, partial);
        const Octree expected = tree_of(voxels);
        ASSERT_EQ(built.tree.levels.size(), expected.levels.size());
        for (std::size_t k = 0; k < expected.levels.size(); ++k) {
          EXPECT_EQ(built.tree.levels[k].kinds, expected.levels[k].kinds) << "level " << k;
        }
        EXPECT_EQ(built.depth_limited_nodes, 0u);
        EXPECT_EQ(built.tree.levels.back().statement.error_bound, 0);
        EXPECT_NEAR(built.tree.levels.back().statement.outer_volume / solid.volume, 1, 1e-12);
      }
    }
  }
}

TEST(Classical, UnitBoxesAnywhereOnTheWallsAreEightFullCells) {
  for (int position = 0; position < 27; ++position) {
    const Vec3 lower = Vec3(position % 3, position / 3 % 3, position / 9) * 0.5 - 1.0;
    const BuiltOctree built = classical(box_solid(lower, lower + 1.0), 6, PartialCells::Full);
    const LevelStatement& last = built.tree.levels.back().statement;
    EXPECT_EQ(last.error_bound, 0);
    EXPECT_EQ(last.inner_volume, 1);
    EXPECT_EQ(last.outer_volume, 1);
    EXPECT_EQ(last.inner_area, 6);
    EXPECT_LE(built.tree.levels.size(), 3u);
  }
}

// A box whose upper face goes through the centres of cells, exactly.
TEST(Classical, ACentreOnTheBoundaryIsInside) {
  const Solid solid = box_solid(Vec3(-0.5), Vec3(0.5, 0.5, 0.25));
  const Octree tree = classical(solid, 2, PartialCells::Half).tree;
  EXPECT_EQ(tree.levels.back().statement.outer_volume, 1);
  EXPECT_EQ(classify_point(tree, Vec3(0.1, 0.1, 0.4)), PointClass::In);
}

TEST(Classical, FullContainsHalfContainsVoid) {
  for (const char* name : {"mechanical-piece", "double-torus", "nested-boxes", "sphere"}) {
    SCOPED_TRACE(name);
    const Solid solid = model_solid(name);
    const auto full = full_cells(classical(solid, 5, PartialCells::Full).tree, 5);
    const auto half = full_cells(classical(solid, 5, PartialCells::Half).tree, 5);
    const auto empty = full_cells(classical(solid, 5, PartialCells::Void).tree, 5);
    for (std::size_t i = 0; i < full.size(); ++i) {
      ASSERT_LE(empty[i], half[i]);
      ASSERT_LE(half[i], full[i]);
    }
  }
}

TEST(Classical, EveryLevelOfAFullTreeContainsTheSolid) {
  for (const char* name : {"mechanical-piece", "double-torus", "two-parts", "sphere"}) {
    SCOPED_TRACE(name);
    const Solid solid = model_solid(name);
    const Octree tree = classical(solid, 5, PartialCells::Full).tree;
    const MeshJudge judge(universe_mesh_of(solid));
    Random random(1);
    for (std::uint32_t k = 0; k < tree.levels.size(); ++k) {
      for (const Vec3 vertex : solid.vertices) {
        ASSERT_NE(classify_point(tree, vertex, k), PointClass::Out) << "level " << k;
      }
      for (int i = 0; i < 2000; ++i) {
        const auto sample = judge.sample(random);
        ASSERT_NE(classify_point(tree, sample.point - 1e-12 * sample.normal, k), PointClass::Out)
            << "level " << k;
      }
    }
  }
}

TEST(Classical, AVoidTreeIsContainedInTheSolid) {
  for (const char* name : {"mechanical-piece", "double-torus", "two-parts", "sphere"}) {
    SCOPED_TRACE(name);
    const Solid solid = model_solid(name);
    const Octree tree = classical(solid, 5, PartialCells::Void).tree;
    const MeshJudge judge(universe_mesh_of(solid));
    Random random(2);
    std::size_t full = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 point = solid.universe.half_side *
                         Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
      if (classify_point(tree, point) != PointClass::In) continue;
      ++full;
      ASSERT_TRUE(judge.is_inside(point));
    }
    EXPECT_GT(full, 100u);
  }
}

/// The cubes of T_k, lower and upper corner.
struct Cubes : PieceVisitor {
  void piece(const NodeAddress&, NodeKind, std::uint32_t, const Polyhedron& piece) override {
    Vec3 lower = piece.vertices.front().position;
    Vec3 upper = lower;
    for (const PolyhedronVertex& vertex : piece.vertices) {
      lower = glm::min(lower, vertex.position);
      upper = glm::max(upper, vertex.position);
    }
    cubes.push_back({lower, upper});
  }
  double distance(Vec3 point) const {
    double least = 1e300;
    for (const auto& [lower, upper] : cubes) {
      least =
          std::min(least, glm::length(glm::max(glm::max(lower - point, point - upper), Vec3{0.0})));
    }
    return least;
  }
  std::vector<std::pair<Vec3, Vec3>> cubes;
};

// What is stated about every level, against the cubes and samples of them and of the surface; and
// that the level decodes, and rebuilds to a closed mesh of the volume and area stated.
void judge_levels(const Solid& solid, int depth, PartialCells partial) {
  const BuiltOctree built = classical(solid, depth, partial);
  const Octree& tree = built.tree;
  const std::string stream = encode_stream(tree, {});
  const MeshJudge judge(universe_mesh_of(solid));
  const double unit = solid.universe.scale();
  Random random(3);
  for (std::uint32_t k = 0; k < tree.levels.size(); ++k) {
    SCOPED_TRACE(testing::Message() << "level " << k);
    const LevelStatement& statement = tree.levels[k].statement;
    const Octree received = decode_stream(stream, k + 1);
    ASSERT_EQ(received.levels.size(), k + 1);
    EXPECT_EQ(received.levels[k].statement, statement);

    const PlainMesh mesh =
        parse_off_text(to_off(make_polygon_mesh(rebuild_surface(received, k), received.universe)));
    EXPECT_EQ(why_not_closed(mesh, false), "");
    EXPECT_NEAR(volume_of(mesh) / statement.outer_volume, 1, 1e-9);
    if (k + 1 == tree.levels.size()) {
      EXPECT_NEAR(area_of(mesh) / statement.outer_area, 1, 1e-9);
      EXPECT_EQ(statement.inner_volume, statement.outer_volume);
      EXPECT_EQ(statement.inner_area, statement.outer_area);
    }
    if (k > 0) {
      const LevelStatement& before = tree.levels[k - 1].statement;
      EXPECT_LE(statement.outer_volume, before.outer_volume);
      EXPECT_GE(statement.inner_volume, before.inner_volume);
      EXPECT_GE(statement.inner_area, before.inner_area);
    }

    Cubes level;
    WalkOptions walk;
    walk.level = k;
    walk_pieces(tree, walk, level);
    double found = 0;  // the largest distance, either way
    const int steps = std::max(2, static_cast<int>(std::cbrt(20000.0 / level.cubes.size())));
    for (const auto& [lower, upper] : level.cubes) {
      for (int i = 0; i < (steps + 1) * (steps + 1) * (steps + 1); ++i) {
        const Vec3 place(i % (steps + 1), i / (steps + 1) % (steps + 1),
                         i / (steps + 1) / (steps + 1));
        const Vec3 point = lower + (upper - lower) * (place / static_cast<double>(steps));
        if (!judge.is_inside(point)) found = std::max(found, judge.distance(point));
      }
    }
    for (int i = 0; i < 3000; ++i) {
      found = std::max(found, level.distance(judge.sample_triangle(random).point));
    }
    for (const Vec3 vertex : solid.vertices) found = std::max(found, level.distance(vertex));
    EXPECT_GE(statement.error_bound / unit, found * (1 - 1e-12));
    if (partial == PartialCells::Full) {
      EXPECT_LE(statement.error_bound / unit, 1.5 * found);  // samples are not dense
    } else if (k + 1 == tree.levels.size()) {
      // A thin layer that is missing over a wide face takes more boxes than are opened.
      const double diagonal = std::sqrt(3.0) * 2 * solid.universe.half_side / (1 << depth);
      EXPECT_LE(statement.error_bound / unit, found + diagonal);
    }
  }
}

TEST(Classical, WhatIsStatedAboutEveryLevelHolds) {
  for (const char* name : {"mechanical-piece", "l-bracket", "double-torus", "nested-boxes",
                           "two-parts", "sphere", "diamond"}) {
    for (const PartialCells partial : kAllPartials) {
      SCOPED_TRACE(testing::Message() << name << ", partial " << static_cast<int>(partial));
      judge_levels(model_solid(name), 4, partial);
    }
  }
}

// A ball of radius r and all cells that its surface passes through lie within a cell's diagonal of
// it: that bounds the volume from above by thinking.
TEST(Classical, TheVolumeOfFullTreesGoesDownToTheSolids) {
  const Solid solid = model_solid("sphere", 40);
  double before = 1e300;
  for (int depth = 0; depth <= 7; ++depth) {
    const LevelStatement last =
        classical(solid, depth, PartialCells::Full).tree.levels.back().statement;
    const double diagonal = solid.universe.diagonal() / (1 << depth);
    EXPECT_GT(last.outer_volume, solid.volume);
    EXPECT_LE(last.outer_volume, before);
    EXPECT_LT(last.outer_volume, 4.0 / 3 * std::numbers::pi * std::pow(50 + diagonal, 3));
    before = last.outer_volume;
    if (depth < 3) continue;
    const LevelStatement inner =
        classical(solid, depth, PartialCells::Void).tree.levels.back().statement;
    EXPECT_LT(inner.outer_volume, solid.volume);
    // The polyhedron's faces are less than 0.2 mm inside the ball.
    EXPECT_GT(inner.outer_volume, 4.0 / 3 * std::numbers::pi * std::pow(49.8 - diagonal, 3));
  }
}

TEST(Classical, AnyNumberOfThreadsMakesTheSameBytes) {
  const Solid solid = model_solid("sphere", 20);
  for (const PartialCells partial : kAllPartials) {
    BuildOptions options;
    options.rules = ClassicalRules{7, partial};
    options.fragments_per_job = 32;
    const SolidQueries queries(solid);
    std::string one;
    for (const std::size_t threads : {1, 2, 5}) {
      const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                              threads);
      BuiltOctree built = build_octree(solid, queries, options);
      certify(built, solid, queries);
      const std::string bytes = encode_stream(built.tree, {});
      if (one.empty()) one = bytes;
      EXPECT_TRUE(bytes == one) << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace spoctree
