// A mesh file whose surface meets itself and the .spo file that `build --repair` made of it -> what
// winding numbers, counted exactly from the file's own triangles, say of the levels: `in` is right
// only where the surface winds at least once, `out` only where it does not.
// Points nearer to one of the file's triangles than --nearest (2e-6 of the diagonal: what merging
// by the default flat tolerance may move) are not asked.
// Usage: judge_winding MESH MODEL.spo [--points N] [--nearest D]
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "common/base/errors.hpp"
#include "common/program/run_program.hpp"
#include "common/tree/query_index.hpp"
#include "common/wire/spo_file.hpp"
#include "tests/support/cgal_mesh.hpp"
#include "tests/support/mesh_judge.hpp"
#include "tests/support/winding_judge.hpp"

namespace spoctree {

namespace {

struct Options {
  std::string mesh;
  std::string model;
  std::size_t points = 100000;
  double nearest = 2e-6;
};

struct Question {
  Vec3 point{0.0};
  std::int64_t winding = 0;
};

/// Half of them anywhere in the universe cube, half `nearest` to 1e-2 of the diagonal off the
/// surface.
std::vector<Question> make_questions(const Options& options, const Universe& universe) {
  const PlainMesh mesh = read_with_cgal(options.mesh);
  const MeshJudge surface(mesh);
  const WindingJudge judge(mesh);
  Random random(20261130);
  std::vector<Question> questions;
  const double half = universe.half_side * universe.scale();
  while (questions.size() < options.points) {
    Vec3 point = universe.center +
                 half * Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (questions.size() % 2 == 1) {
      const auto sample =
          random.chance(0.5) ? surface.sample(random) : surface.sample_triangle(random);
      const double off = std::pow(10.0, random.between(std::log10(options.nearest), -2));
      point = sample.point + sample.normal * (random.chance(0.5) ? off : -off) * surface.diagonal();
    }
    // What is off one triangle may be on another.
    if (surface.distance(point) < 0.999 * options.nearest * surface.diagonal()) continue;
    questions.push_back({point, judge.winding(point, random)});
  }
  // A surface that faces inwards everywhere is turned.
  const auto is_less = [](const Question& p, const Question& q) { return p.winding < q.winding; };
  const auto [least, most] = std::minmax_element(questions.begin(), questions.end(), is_less);
  if (least->winding < 0 && most->winding <= 0) {
    for (Question& question : questions) question.winding = -question.winding;
  }
  return questions;
}

int judge(const Options& options) {
  const Octree tree = SpoFile(options.model).tree();
  const std::vector<Question> questions = make_questions(options, tree.universe);
  std::vector<std::uint8_t> was_wrong(questions.size(), 0);
  const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
  std::size_t wrong_at_last = 0;
  std::size_t unknown_at_last = 0;
  for (std::uint32_t k = 0; k <= last; ++k) {
    const QueryIndex index(tree, k);
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const auto& [point, winding] = questions[i];
      const PointClass now = index.classify(tree.universe.to_universe(point));
      if (now == PointClass::Unknown) {
        unknown_at_last += k == last;
        continue;
      }
      if (now == (winding > 0 ? PointClass::In : PointClass::Out)) continue;
      wrong_at_last += k == last;
      if (was_wrong[i] == 0 && std::count(was_wrong.begin(), was_wrong.end(), 1) < 3) {
        std::fprintf(stderr, "%s: level %u says %d of (%.17g %.17g %.17g), wound around %lld x\n",
                     options.mesh.c_str(), k, static_cast<int>(now), point.x, point.y, point.z,
                     static_cast<long long>(winding));
      }
      was_wrong[i] = 1;
    }
  }
  const auto wrong_at_any = std::count(was_wrong.begin(), was_wrong.end(), 1);
  const auto count_if = [&](auto is_so) {
    return std::count_if(questions.begin(), questions.end(),
                         [&](const Question& question) { return is_so(question.winding); });
  };
  const bool is_right = wrong_at_any == 0 && unknown_at_last == 0;
  std::printf(
      "%-46s %2zu levels | %zu points (wound around < 0: %td, 0: %td, 1: %td, > 1: %td) | "
      "wrong %zu last, %td any, unknown %zu%s\n",
      options.mesh.substr(options.mesh.rfind('/') + 1).c_str(), tree.levels.size(),
      questions.size(), count_if([](std::int64_t w) { return w < 0; }),
      count_if([](std::int64_t w) { return w == 0; }),
      count_if([](std::int64_t w) { return w == 1; }),
      count_if([](std::int64_t w) { return w > 1; }), wrong_at_last, wrong_at_any, unknown_at_last,
      is_right ? "" : "  <-- FAILS");
  return is_right ? kExitDone : 1;
}

}  // namespace

}  // namespace spoctree

int main(int argc, char** argv) {
  CLI::App app("Judges what repair made of a mesh by its winding numbers", "judge_winding");
  spoctree::Options options;
  app.add_option("MESH", options.mesh)->required();
  app.add_option("MODEL", options.model)->required();
  app.add_option("--points", options.points, "Points to classify");
  app.add_option("--nearest", options.nearest, "Judge no points nearer to the surface (diagonals)");
  int verdict = 0;
  app.callback([&] { verdict = spoctree::judge(options); });
  const int code = spoctree::run_program(app, argc, argv);
  return code != 0 ? code : verdict;
}
