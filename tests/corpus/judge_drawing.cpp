// A mesh and a drawing of it (JSON) -> what an exact method that knows only the mesh says of the
// drawing: lengths as fractions of the length of all edges that are seen.
// Usage: judge_drawing MESH DRAWING.json --from X,Y,Z | --eye X,Y,Z --target X,Y,Z [--up X,Y,Z]
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "common/base/errors.hpp"
#include "common/program/run_program.hpp"
#include "tests/support/cgal_mesh.hpp"
#include "tests/support/read_drawing.hpp"

namespace spoctree {

namespace {

struct Options {
  std::string mesh, drawing, name, from, eye, target, up = "0,0,1";
  double half_angle_deg = 80;
  JudgeOptions judge;
  bool shows_bends = false;
};

Vec3 parse_vector(const std::string& text) {
  Vec3 result{0.0};
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf", &result.x, &result.y, &result.z) != 3) {
    throw UsageError(text + " is not X,Y,Z");
  }
  return result;
}

JudgeView view_of(const Options& options) {
  if (options.eye.empty()) return JudgeView::parallel(parse_vector(options.from));
  return JudgeView::perspective(parse_vector(options.eye), parse_vector(options.target),
                                parse_vector(options.up), options.half_angle_deg);
}

void print_bends(const PlainMesh& mesh) {
  std::size_t counts[20] = {};
  for (const double bend : edge_bends(mesh)) {
    const double exponent = bend > 0 ? -std::log10(bend) : 19;
    ++counts[static_cast<int>(std::clamp(exponent, 0.0, 19.0))];
  }
  for (int k = 0; k < 20; ++k)
    std::printf("%s%zu", k == 0 ? "bends below 1e0, 1e-1, ...: " : " ", counts[k]);
  std::printf("\n");
}

int judge(const Options& options) {
  const PlainMesh mesh = read_with_cgal(options.mesh);
  if (options.shows_bends) print_bends(mesh);
  const auto lines = read_drawing(options.drawing);
  const auto start = std::chrono::steady_clock::now();
  const DrawingJudgement found = judge_drawing(mesh, view_of(options), lines, options.judge);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const double seen = found.seen > 0 ? found.seen : 1;
  const std::string name =
      options.name.empty() ? options.mesh.substr(options.mesh.rfind('/') + 1) : options.name;
  const auto share = [&](const char* what, double length) {
    if (length > 0) {
      std::printf("%s %.1e", what, length / seen);
    } else {
      std::printf("%s 0", what);
    }
  };
  std::printf("%-46s %6zu lines for %6zu, %5.2f pieces |", name.c_str(), found.lines,
              found.seen_runs, found.pieces_per_run());
  share(" no edge", found.no_edge);
  share(", hidden", found.not_seen);
  share(", missed", found.missed);
  share(", doubled", found.doubled);
  share(", nearly", found.nearly_doubled);
  share(", off in space", found.off_in_space);
  if (found.hidden_lines > 0) {
    std::printf(" | %zu dashed:", found.hidden_lines);
    share(" seen", found.wrongly_hidden);
    share(", missed", found.missed_hidden);
    share(", doubled", found.doubled_hidden);
  }
  if (found.doubtful > 0) share(" | doubtful", found.doubtful);
  std::printf(" | %.1f s%s\n", took.count(), found.is_good() ? "" : "  <-- FAILS");
  std::fflush(stdout);  // before the faults
  for (const std::string& fault : found.faults) std::fprintf(stderr, "  %s\n", fault.c_str());
  return found.is_good() ? kExitDone : 1;
}

}  // namespace

}  // namespace spoctree

int main(int argc, char** argv) {
  CLI::App app("Judges a drawing by the mesh it is of", "judge_drawing");
  spoctree::Options options;
  app.add_option("MESH", options.mesh, "The solid that is drawn")->required();
  app.add_option("DRAWING", options.drawing, "JSON, as `draw` writes it")->required();
  auto* from = app.add_option("--from", options.from, "X,Y,Z: the direction towards the viewer");
  auto* eye = app.add_option("--eye", options.eye, "X,Y,Z: where the viewer is")->excludes(from);
  app.add_option("--target", options.target, "X,Y,Z: what the viewer looks at")->needs(eye);
  eye->needs(app.get_option("--target"));
  app.add_option("--up", options.up, "X,Y,Z");
  app.add_option("--half-angle", options.half_angle_deg, "Degrees off the axis that are judged");
  app.add_option("--tolerance", options.judge.tolerance, "Of the diagonal");
  app.add_option("--crease-angle", options.judge.edges.crease_angle_deg,
                 "Degrees: where the surface turns by less, outlines alone are edges");
  app.add_option("--flat", options.judge.edges.flat, "Faces bent by less have no edge (diagonals)");
  app.add_option("--bent", options.judge.edges.bent, "Faces bent by more have one (diagonals)");
  app.add_option("--faults", options.judge.faults_told, "How many of each kind are described");
  app.add_option("--name", options.name, "What to call the drawing");
  app.add_flag("--bends", options.shows_bends, "Count the edges by how bent the mesh is there");
  int verdict = 0;
  app.callback([&] {
    if (options.from.empty() && options.eye.empty()) throw spoctree::UsageError("no view is given");
    verdict = spoctree::judge(options);
  });
  const int code = spoctree::run_program(app, argc, argv);
  return code != 0 ? code : verdict;
}
