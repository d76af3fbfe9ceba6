// Models and meshes -> whether both methods of drawing draw the same, what each costs, and how both
// stand before the judge that knows the mesh alone. One line per view, as text or as CSV.
// Usage: compare_methods [--csv FILE] [--judge] [--inside N] MODEL_NAME|MESH_FILE...
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <numbers>

#include "client/cells/cell_scene.hpp"
#include "client/lines/extent.hpp"
#include "common/base/errors.hpp"
#include "common/program/run_program.hpp"
#include "server/build/build_octree.hpp"
#include "server/mesh/read_mesh.hpp"
#include "server/solid/import_solid.hpp"
#include "tests/support/compare_drawings.hpp"
#include "tests/support/drawing_judge.hpp"
#include "tests/support/eyes_within.hpp"
#include "tests/support/model_solid.hpp"
#include "tests/support/solid_mesh.hpp"
#include "tools/model/models.hpp"

namespace spoctree {

namespace {

struct Options {
  std::vector<std::string> sources;
  std::string csv;
  bool judges = false;
  std::size_t eyes_inside = 2;
  double tolerance = 1e-6;
};

constexpr double kHalfAngleDeg = 45;  // of the views from within
constexpr int kRuns = 3;              // the fastest counts

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The fastest of some runs.
template <class Run>
double timed(Run&& run) {
  double best = 1e300;
  for (int k = 0; k < kRuns; ++k) {
    const auto start = std::chrono::steady_clock::now();
    run();
    best = std::min(best, seconds_since(start));
  }
  return best;
}

Solid solid_of(const std::string& source) {
  for (const model::ModelInfo& info : model::models()) {
    if (info.name != source) continue;
    return model_solid(source);
  }
  return import_solid(read_mesh(source), source, {});
}

struct TriedView {
  std::string name;
  Camera camera;
  Rectangle frame;
  double half_angle_deg = 80;  // of the judge's window
};

std::vector<TriedView> views_of(const Octree& tree, const EmptySpace& space, std::size_t inside) {
  std::vector<TriedView> views;
  const auto add = [&](std::string name, const Camera& camera) {
    views.push_back({std::move(name), camera, extent_of_universe(tree.universe, camera)});
  };
  add("outside", Camera(Vec3{0.55, -0.71, 0.44}));
  add("front", Camera(Vec3{0, -1, 0}));
  add("eye outside", Camera::perspective({2.1, -3.3, 1.7}, {0, 0, 0}));
  for (const EyeWithin& eye : eyes_within(space, inside)) {
    // Towards the middle, or to where there is more room from it.
    Vec3 way = -eye.at;
    if (glm::length(way) < 1e-3) way = {1, 0.3, 0.2};
    const Camera camera = Camera::perspective(eye.at, eye.at + way);
    const double half = camera.focal_length() * std::tan(kHalfAngleDeg * std::numbers::pi / 180);
    views.push_back({eye.is_in_cavity ? "in a cavity" : "within",
                     camera,
                     {{-half, -half}, {half, half}},
                     kHalfAngleDeg});
  }
  return views;
}

DrawingJudgement judgement(const PlainMesh& mesh, const Universe& universe, const TriedView& tried,
                           const VisibleLines& lines) {
  const Camera& camera = tried.camera;
  const auto to_model = [&](Vec3 point) { return universe.to_model(point); };
  const JudgeView view =
      camera.is_perspective()
          ? JudgeView::perspective(
                to_model(camera.eye()),
                to_model(camera.eye() - camera.focal_length() * camera.toward_viewer()), {0, 0, 1},
                tried.half_angle_deg)
          : JudgeView::parallel(camera.toward_viewer());
  std::vector<DrawnLine> drawn;
  for (const VisibleLine& line : lines) {
    drawn.push_back({to_model(line.a), to_model(line.b), line.hidden});
  }
  return judge_drawing(mesh, view, drawn);
}

class Comparer {
 public:
  explicit Comparer(const Options& options) : options_(options) {
    if (options.csv.empty()) return;
    csv_ = std::fopen(options.csv.c_str(), "w");
    if (csv_ == nullptr) throw BadInput(options.csv + ": cannot write");
    std::fprintf(csv_,
                 "model,faces,view,lines,length,only_front_to_back,only_cells,front_prepare_s,"
                 "front_draw_s,cells_prepare_s,cells_draw_s,cells_before_merging,cells,openings,"
                 "avenues,cells_seen,longest,judge_front_to_back,judge_cells\n");
  }
  ~Comparer() {
    if (csv_ != nullptr) std::fclose(csv_);
  }

  bool all_equal() const { return all_equal_; }

  void compare(const std::string& source) {
    std::string name = source.substr(source.rfind('/') + 1);
    name = name.substr(0, name.rfind('.'));
    const Solid solid = solid_of(source);
    const Octree tree = build_octree(solid, SolidQueries(solid), {}).tree;
    const Surface surface = rebuild_surface(tree);
    const double front_prepare = timed([&] { LineScene(tree, surface); });
    const LineScene scene(tree, surface);
    const double cells_prepare = timed([&] { CellScene{scene}; });
    const CellScene cells(scene);
    const PlainMesh mesh = mesh_of(solid);
    for (const TriedView& tried : views_of(tree, cells.space(), options_.eyes_inside)) {
      LineOptions line_options;
      line_options.frame = tried.frame;
      AvenueCounts counts;
      VisibleLines front, seen;
      const double front_draw =
          timed([&] { front = visible_lines(scene, tried.camera, line_options); });
      line_options.find_seen_parts = cells.finder(&counts);
      const double cells_draw =
          timed([&] { seen = visible_lines(scene, tried.camera, line_options); });
      const double unit = scene.diagonal();
      const DrawingDifference difference =
          compare_drawings(front, seen, tried.camera, tried.frame, options_.tolerance * unit);
      const bool is_equal = difference.only_first + difference.only_second == 0;
      all_equal_ &= is_equal;
      std::string verdicts[2] = {"-", "-"};
      if (options_.judges) {
        for (const bool second : {false, true}) {
          const auto found = judgement(mesh, tree.universe, tried, second ? seen : front);
          verdicts[second] = found.is_good() ? "good" : "FAILS";
          for (const std::string& fault : found.faults) {
            std::fprintf(stderr, "  %s %s: %s\n", name.c_str(), second ? "cells" : "front to back",
                         fault.c_str());
          }
        }
      }
      std::printf(
          "%-34s %-12s %6zu lines, only one draws %.1e, %.1e of %.1f | front to back "
          "%.4f + %.4f s | cells %.4f + %.4f s, %zu cells, %zu openings, %llu avenues, "
          "longest %u | %s %s%s\n",
          name.c_str(), tried.name.c_str(), front.size(), difference.only_first / unit,
          difference.only_second / unit, difference.length / unit, front_prepare, front_draw,
          cells_prepare, cells_draw, cells.space().cells().size(),
          cells.space().openings().openings.size(), static_cast<unsigned long long>(counts.avenues),
          counts.longest, verdicts[0].c_str(), verdicts[1].c_str(),
          is_equal ? "" : "  <-- DIFFERS");
      std::fflush(stdout);
      for (const std::string& fault : difference.faults)
        std::fprintf(stderr, "  %s\n", fault.c_str());
      if (csv_ == nullptr) continue;
      std::fprintf(csv_,
                   "%s,%zu,%s,%zu,%.6g,%.3g,%.3g,%.6f,%.6f,%.6f,%.6f,%zu,%zu,%zu,%llu,%llu,%u,%s,"
                   "%s\n",
                   name.c_str(), surface.faces.size(), tried.name.c_str(), front.size(),
                   difference.length / unit, difference.only_first / unit,
                   difference.only_second / unit, front_prepare, front_draw, cells_prepare,
                   cells_draw, cells.space().cells_of_partition(), cells.space().cells().size(),
                   cells.space().openings().openings.size(),
                   static_cast<unsigned long long>(counts.avenues),
                   static_cast<unsigned long long>(counts.cells), counts.longest,
                   verdicts[0].c_str(), verdicts[1].c_str());
    }
  }

 private:
  const Options& options_;
  std::FILE* csv_ = nullptr;
  bool all_equal_ = true;
};

}  // namespace

}  // namespace spoctree

int main(int argc, char** argv) {
  CLI::App app("Compares both methods of drawing", "compare_methods");
  spoctree::Options options;
  app.add_option("SOURCE", options.sources, "Names of models, and mesh files")->required();
  app.add_option("--csv", options.csv, "A file for the figures");
  app.add_flag("--judge", options.judges, "Judge both drawings by the mesh, too");
  app.add_option("--inside", options.eyes_inside, "How many eyes are within the solid's hull");
  app.add_option("--tolerance", options.tolerance, "Of the universe cube's diagonal");
  bool all_equal = true;
  app.callback([&] {
    spoctree::Comparer comparer(options);
    for (const std::string& source : options.sources) comparer.compare(source);
    all_equal = comparer.all_equal();
  });
  const int code = spoctree::run_program(app, argc, argv);
  return code != 0 ? code : (all_equal ? 0 : 1);
}
