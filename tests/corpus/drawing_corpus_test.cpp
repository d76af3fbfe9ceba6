// Drawings of models that others made (environment variable SPOCTREE_MESHES) show what rays say is
// seen: at first, middle and last level, from odd directions and square on.
#include <gtest/gtest.h>

#include <filesystem>

#include "client/lines/visible_lines.hpp"
#include "server/build/build_octree.hpp"
#include "server/mesh/read_mesh.hpp"
#include "server/solid/import_solid.hpp"
#include "tests/support/meshes_folder.hpp"
#include "tests/support/sight_oracle.hpp"

namespace spoctree {
namespace {

namespace fs = std::filesystem;

constexpr Vec3 kViews[] = {
    {0.55, -0.71, 0.44}, {-0.3, 0.2, -0.9}, {0, -1, 0}, {0, 0, 1}, {1, 1, 0}};

class DrawingCorpus : public testing::TestWithParam<const char*> {};

TEST_P(DrawingCorpus, ShowsWhatRaysSee) {
  const char* folder = meshes_folder();
  if (folder == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
  const Solid solid = import_solid(read_mesh(fs::path(folder) / GetParam()), GetParam(), {1e-12});
  const SolidQueries queries(solid);
  const Octree tree = build_octree(solid, queries, {}).tree;
  const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
  std::size_t tried = 0;
  for (const std::uint32_t level : {0u, last / 2, last}) {
    const Surface surface = rebuild_surface(tree, level);
    LineOptions options;
    options.level = level;
    for (const Vec3 view : kViews) {
      const VisibleLines lines = visible_lines(tree, surface, Camera(view), options);
      const SightOracle oracle(surface, tree.plane_set(), view);
      for (const std::string& error : compare(lines, oracle, 1, tried)) {
        ADD_FAILURE() << "level " << level << ", seen from (" << view.x << ", " << view.y << ", "
                      << view.z << "): " << error;
      }
    }
  }
  EXPECT_GT(tried, 100u);
}

// The nut and the part have faces that are flat up to the rounding of single precision only: many
// planes that almost coincide, many faces that are almost seen edge-on.
INSTANTIATE_TEST_SUITE_P(Models, DrawingCorpus,
                         testing::Values("cad/hex-nut-M3_620f.stl", "cad/part_346f.off",
                                         "cad/u-profile_168f.off", "cad/couplingdown_3714f.off",
                                         "cad/anchor_1050f.off", "cad/cross_38quads.off",
                                         "scan/stanford-bunny-filled_998f.off"),
                         [](const auto& tested) { return test_name_of(tested.param); });

}  // namespace
}  // namespace spoctree
