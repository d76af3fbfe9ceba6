// A .spo file -> how far each level is from the last one, on average: what a viewer has for the
// bytes that have arrived. Distances are sampled on the rebuilt boundaries and found by CGAL.
// Usage: level_distances MODEL.spo [--samples N]
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "client/rebuild/polygon_mesh.hpp"
#include "client/rebuild/surface_rebuilder.hpp"
#include "common/program/run_program.hpp"
#include "common/wire/spo_file.hpp"
#include "tests/support/mesh_judge.hpp"

namespace spoctree {

namespace {

struct Options {
  std::string model;
  std::size_t samples = 100000;
};

PlainMesh boundary_of(const Octree& tree, std::uint32_t level, SurfaceRebuilder& rebuilder) {
  const PolygonMesh mesh = make_polygon_mesh(rebuilder.rebuild(tree, level), tree.universe);
  PlainMesh plain;
  plain.points = mesh.vertices;
  for (std::size_t i = 0; i < mesh.polygon_count(); ++i) {
    plain.faces.emplace_back(mesh.corners.begin() + mesh.polygon_begin[i],
                             mesh.corners.begin() + mesh.polygon_begin[i + 1]);
  }
  return plain;
}

/// The mean distance of `from`'s points from `to`.
double mean_distance(const MeshJudge& from, const MeshJudge& to, std::size_t samples) {
  Random random(20261130);
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i) sum += to.distance(from.sample(random).point);
  return sum / static_cast<double>(samples);
}

/// One line a level: number, bytes up to its end, and the mean distance, that of the worse
/// direction, in % of the solid's bounding box's diagonal.
void print_distances(const Options& options) {
  const SpoFile file(options.model);
  const Octree tree = file.tree();
  const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
  SurfaceRebuilder whole;
  const MeshJudge solid(boundary_of(tree, last, whole));
  SurfaceRebuilder rebuilder;
  for (std::uint32_t k = 0; k <= last; ++k) {
    double mean = 0;
    if (k < last) {
      const MeshJudge level(boundary_of(tree, k, rebuilder));
      mean = std::max(mean_distance(level, solid, options.samples),
                      mean_distance(solid, level, options.samples));
    }
    std::printf("%u %llu %.5g\n", k,
                static_cast<unsigned long long>(file.level_bytes()[k].total_bytes), 100 * mean / solid.diagonal());
  }
}

}  // namespace

}  // namespace spoctree

int main(int argc, char** argv) {
  CLI::App app("Says how far each level is from the solid, on average", "level_distances");
  spoctree::Options options;
  app.add_option("MODEL", options.model)->required();
  app.add_option("--samples", options.samples, "Points on each boundary");
  app.callback([&] { spoctree::print_distances(options); });
  return spoctree::run_program(app, argc, argv);
}
