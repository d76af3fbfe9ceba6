// Ten real solids, from outside and, where they have cavities or holes, from within: avenues of
// sight show what is seen from front to back.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "client/cells/cell_scene.hpp"
#include "client/lines/extent.hpp"
#include "server/build/build_octree.hpp"
#include "server/mesh/read_mesh.hpp"
#include "server/solid/import_solid.hpp"
#include "tests/support/compare_methods.hpp"
#include "tests/support/eyes_within.hpp"
#include "tests/support/meshes_folder.hpp"

namespace spoctree {
namespace {

namespace fs = std::filesystem;

class MethodsCorpus : public testing::TestWithParam<const char*> {};

/// Returns the length of what is seen.
double expect_same(const LineScene& scene, const CellScene& cells, const Camera& camera,
                   const Rectangle& frame) {
  const DrawingDifference difference = compare_methods(scene, cells, camera, frame);
  EXPECT_EQ(difference.only_first, 0);
  EXPECT_EQ(difference.only_second, 0);
  for (const std::string& fault : difference.faults) ADD_FAILURE() << fault;
  return difference.length;
}

TEST_P(MethodsCorpus, DrawTheSame) {
  if (meshes_folder() == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
  const fs::path path = fs::path(meshes_folder()) / GetParam();
  const Solid solid = import_solid(read_mesh(path), path.string(), {});
  // By the paper's rule there are middle levels to look at; by default, leaves are larger.
  BuildOptions options;
  options.rules = kPaperRules;
  const SolidQueries queries(solid);
  const Octree fine = build_octree(solid, queries, options).tree;
  const Octree coarse = build_octree(solid, queries, {}).tree;
  const auto last = static_cast<std::uint32_t>(fine.levels.size() - 1);
  const auto coarse_last = static_cast<std::uint32_t>(coarse.levels.size() - 1);
  const std::tuple<const Octree&, std::uint32_t> cases[] = {
      {fine, last / 2}, {fine, last}, {coarse, coarse_last}};
  double seen_within = 0;
  std::size_t eyes = 0;
  for (const auto& [tree, level] : cases) {
    SCOPED_TRACE("level " + std::to_string(level) + " of " + std::to_string(tree.levels.size()));
    const LineScene scene(tree, rebuild_surface(tree, level), level);
    const CellScene cells(scene);
    for (const Camera& camera :
         {Camera(), Camera(Vec3{0, -1, 0}), Camera::perspective({2.1, -3.3, 1.7}, {0, 0, 0})}) {
      EXPECT_GT(expect_same(scene, cells, camera, extent_of_universe(tree.universe, camera)), 0);
    }
    for (const EyeWithin& eye : eyes_within(cells.space(), 2)) {
      const Camera camera = Camera::perspective(eye.at, eye.at + Vec3{0.4, 0.7, -0.2});
      const double half = 1.5 * camera.focal_length();
      seen_within += expect_same(scene, cells, camera, {{-half, -half}, {half, half}});
      ++eyes;
    }
  }
  // A single eye may look at a wall without an edge.
  if (eyes > 0) {
    EXPECT_GT(seen_within, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Models, MethodsCorpus,
    testing::Values("nested/openscad-projection_cavity_4160f.stl",
                    "nested/y-belt-tensioner_5cavities_2366f.stl", "polygons/3torus_quads_23f.off",
                    "polygons/hole_quads_28f.off", "cad/anchor_1050f.off", "cad/spool_1294f.off",
                    "cad/couplingdown_3714f.off", "high-genus/helmet_1000f.off",
                    "multi/eryone-er20_792f.stl", "scan/stanford-bunny-filled_998f.off"),
    [](const auto& tested) { return test_name_of(tested.param); });

}  // namespace
}  // namespace spoctree
