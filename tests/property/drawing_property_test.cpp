// What is drawn of models, cells and degenerate trees, at first, middle and last level, is what an
// exact method sees of the mesh: in general, axis-aligned, diagonal and perspective views.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <ostream>

#include "client/lines/line_scene.hpp"
#include "client/lines/visible_lines.hpp"
#include "client/rebuild/polygon_mesh.hpp"
#include "server/build/build_octree.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/drawing_judge.hpp"
#include "tests/support/meshes_folder.hpp"
#include "tests/support/model_solid.hpp"
#include "tests/support/solid_mesh.hpp"
#include "tests/support/voxels.hpp"
#include "tests/unit/judge/judge_scenes.hpp"

namespace spoctree {
namespace {

/// A view in universe coordinates.
struct TriedView {
  const char* name;
  Vec3 toward_viewer{0.0};
  Vec3 eye{0.0};  ///< for perspectives, where toward_viewer is zero
  Vec3 target{0.0};
};

const std::vector<TriedView> kViews = {
    {"general", {0.55, -0.71, 0.44}},
    {"front", {0, -1, 0}},
    {"top", {0, 0, 1}},
    {"almost front", {0.002, -1, 0.001}},
    {"hardly off the front", {1e-7, -1, -2e-7}},
    {"diagonal", {1, 1, 0}},
    {"cube's diagonal", {-1, 1, 1}},
    {"eye", {}, {2.1, -3.3, 1.7}, {0.1, 0, -0.1}},
    {"eye in front", {}, {0, -4, 0}, {0, 0, 0}},
};

std::vector<DrawnLine> drawn_lines(const LineScene& scene, const TriedView& tried, bool with_hidden,
                                   double crease_angle_deg) {
  const bool is_perspective = tried.toward_viewer == Vec3(0.0);
  const Camera camera =
      is_perspective ? Camera::perspective(tried.eye, tried.target) : Camera(tried.toward_viewer);
  LineOptions options;
  options.with_hidden_lines = with_hidden;
  options.crease_angle_deg = crease_angle_deg;
  std::vector<DrawnLine> result;
  const Universe& universe = scene.tree().universe;
  for (const VisibleLine& line : visible_lines(scene, camera, options)) {
    result.push_back({universe.to_model(line.a), universe.to_model(line.b), line.hidden});
  }
  return result;
}

JudgeView judge_view(const TriedView& tried, const Universe& universe) {
  if (tried.toward_viewer != Vec3(0.0)) return JudgeView::parallel(tried.toward_viewer);
  return JudgeView::perspective(universe.to_model(tried.eye), universe.to_model(tried.target));
}

/// The length seen, in diagonals.
double expect_right(const std::string& name, const Octree& tree, std::uint32_t level,
                    const PlainMesh& mesh, const std::vector<TriedView>& views,
                    double crease_angle_deg = 0) {
  const LineScene scene(tree, rebuild_surface(tree, level), level);
  double seen = 0;
  for (const TriedView& tried : views) {
    SCOPED_TRACE(name + ", level " + std::to_string(level) + ", " + tried.name);
    const bool with_hidden = tried.name == std::string("general");
    JudgeOptions options;
    options.edges.crease_angle_deg = crease_angle_deg;
    const auto found =
        judge_drawing(mesh, judge_view(tried, tree.universe),
                      drawn_lines(scene, tried, with_hidden, crease_angle_deg), options);
    seen += found.seen / found.diagonal;
    if (found.is_good()) continue;
    ADD_FAILURE() << "no edge " << found.no_edge << ", hidden " << found.not_seen << ", missed "
                  << found.missed << ", doubled " << found.doubled << ", of " << found.seen;
    for (const std::string& fault : found.faults) ADD_FAILURE() << fault;
  }
  return seen;
}

PlainMesh rebuilt_mesh(const Octree& tree, std::uint32_t level) {
  const PolygonMesh polygons = make_polygon_mesh(rebuild_surface(tree, level), tree.universe);
  PlainMesh mesh;
  mesh.points = polygons.vertices;
  for (std::size_t k = 0; k < polygons.polygon_count(); ++k) {
    mesh.faces.emplace_back(polygons.corners.begin() + polygons.polygon_begin[k],
                            polygons.corners.begin() + polygons.polygon_begin[k + 1]);
  }
  return mesh;
}

struct TriedModel {
  const char* name;
  std::optional<int> size;
};

void PrintTo(const TriedModel& model, std::ostream* out) { *out << model.name; }

class DrawingsOfModels : public testing::TestWithParam<TriedModel> {};

TEST_P(DrawingsOfModels, ShowWhatIsSeen) {
  const Solid solid = model_solid(GetParam().name, GetParam().size);
  const Octree tree = build_octree(solid, SolidQueries(solid), {}).tree;
  const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
  for (const std::uint32_t level : {0u, last / 2}) {
    expect_right(GetParam().name, tree, level, rebuilt_mesh(tree, level), kViews);
  }
  std::vector<TriedView> views = kViews;
  if (GetParam().name == std::string("nested-boxes")) {
    // In the outer cavity, which reaches from 15 to 30 mm off the middle.
    const double unit = 1 / solid.universe.scale();
    views.push_back({"eye in a cavity", {}, 22 * unit * Vec3(1, -1, 0), 15 * unit * Vec3(1, 1, 1)});
  }
  EXPECT_GT(expect_right(GetParam().name, tree, last, mesh_of(solid), views), 5);
  for (const double angle : {20.0, 61.0}) {
    EXPECT_GT(expect_right(GetParam().name, tree, last, mesh_of(solid), views, angle), 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, DrawingsOfModels,
                         testing::Values(TriedModel{"mechanical-piece", {}},
                                         TriedModel{"l-bracket", {}},
                                         TriedModel{"double-torus", {}},
                                         TriedModel{"nested-boxes", {}},
                                         TriedModel{"two-parts", {}}, TriedModel{"saddle", {}},
                                         TriedModel{"wavy-sphere", 10}, TriedModel{"sphere", 8},
                                         TriedModel{"cylinder", 40}, TriedModel{"cone", 24}),
                         [](const auto& tested) { return test_name_of(tested.param.name); });

/// The boundary of voxels, square by square, around the origin.
PlainMesh mesh_of(const Voxels& voxels, const Universe& universe) {
  PlainMesh mesh = cells(voxels.side(), [&](int x, int y, int z) { return voxels(x, y, z); });
  const double step = 2 * universe.half_side / voxels.side();
  for (Vec3& p : mesh.points) p = universe.to_model(step * p - universe.half_side);
  return mesh;
}

TEST(DrawingProperty, OfAMengerSpongeIsWhatIsSeen) {
  const Voxels sponge{4, [](int x, int y, int z) {
                        return std::max({x, y, z}) < 9 && is_in_sponge(x, y, z, 2);
                      }};
  for (const bool merged : {true, false}) {
    const Octree tree = tree_of(sponge, merged);
    const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
    EXPECT_GT(expect_right("sponge", tree, last, mesh_of(sponge, tree.universe), kViews), 50);
  }
}

TEST(DrawingProperty, OfRandomCellsIsWhatIsSeen) {
  double seen = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    std::vector<bool> is_full;
    const double density = random.between(0.1, 0.9);
    for (int k = 0; k < 512; ++k) is_full.push_back(random.chance(density));
    const Voxels voxels{3, [&](int x, int y, int z) {
                          return is_full[static_cast<std::size_t>((x * 8 + y) * 8 + z)];
                        }};
    const Octree tree = tree_of(voxels);
    const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
    const std::string name = "cells " + std::to_string(seed);
    seen += expect_right(name, tree, last, mesh_of(voxels, tree.universe), kViews);
  }
  EXPECT_GT(seen, 100);
}

TEST(DrawingProperty, OfTreesFullOfCoincidencesIsWhatIsSeen) {
  double seen = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Octree tree = degenerate_tree(seed, 2 + random.below(3));
    const auto level = random.below(static_cast<std::uint32_t>(tree.levels.size()));
    const PlainMesh mesh = rebuilt_mesh(tree, level);
    if (mesh.faces.empty()) continue;
    seen += expect_right("tree " + std::to_string(seed), tree, level, mesh, kViews);
  }
  EXPECT_GT(seen, 100);
}

}  // namespace
}  // namespace spoctree
