// A mesh file and the .spo file made of it -> what a judge that knows only the mesh says of the
// levels. The mesh is read by CGAL, points are located by CGAL's exact predicates.
// Usage: judge_model MESH MODEL.spo [--points N] [--nearest D] [--moved D] [--rebuilt FILE.off]
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <glm/geometric.hpp>
#include <sstream>

#include "common/base/errors.hpp"
#include "common/program/run_program.hpp"
#include "common/tree/classify.hpp"
#include "common/tree/pieces.hpp"
#include "common/tree/query_index.hpp"
#include "common/wire/spo_file.hpp"
#include "tests/support/cgal_mesh.hpp"
#include "tests/support/mesh_judge.hpp"

namespace spoctree {

namespace {

struct Options {
  std::string mesh;
  std::string model;
  std::string rebuilt;
  std::string name;  // in the report
  std::size_t points = 100000;
  double nearest = 1e-6;  // of the diagonal: points closer to the surface are not judged
  double moved = 0;       // of the diagonal: the solid served may be so far from the mesh
};

/// The uncertain pieces of a level, by their corners.
struct GreyPieces : PieceVisitor {
  void piece(const NodeAddress&, NodeKind kind, std::uint32_t, const Polyhedron& piece) override {
    if (kind != NodeKind::Grey) return;
    std::vector<Vec3> corners;
    for (const PolyhedronVertex& vertex : piece.vertices) corners.push_back(vertex.position);
    pieces.push_back(std::move(corners));
  }
  std::vector<std::vector<Vec3>> pieces;
};

Vec3 random_mixture(const std::vector<Vec3>& corners, Random& random) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  Vec3 sum{0.0};
  double total = 0;
  for (std::uint32_t i = 0; i < 2 + random.below(3); ++i) {
    const double weight = random.unit() + 1e-9;
    sum += weight * corners[random.below(count)];
    total += weight;
  }
  return sum / total;
}

class Judge {
 public:
  explicit Judge(const Options& options)
      : options_(options),
        mesh_(read_with_cgal(options.mesh)),
        judge_(mesh_),
        tree_(SpoFile(options.model).tree()) {}

  int run() {
    const std::string name =
        options_.name.empty() ? options_.mesh.substr(options_.mesh.rfind('/') + 1) : options_.name;
    judge_points();
    judge_bounds();
    const double volume = volume_of(mesh_);
    const double stated = tree_.levels.back().statement.inner_volume;
    std::printf(
        "%-46s %8zu faces %2zu levels | %zu points: wrong %zu last, %zu any, unknown %zu | "
        "bound %s, at most %.2f x | volume %+.1e",
        name.c_str(), mesh_.faces.size(), tree_.levels.size(), judged_, wrong_at_last_,
        wrong_at_any_, unknown_at_last_, bounds_hold_ ? "holds" : "BROKEN", loosest_bound_,
        stated / volume - 1);
    bool is_closed = true;
    if (!options_.rebuilt.empty()) {
      std::ifstream file(options_.rebuilt);
      std::stringstream text;
      text << file.rdbuf();
      const PlainMesh rebuilt = parse_off_text(text.str());
      const std::string fault = why_not_closed(rebuilt, true);
      is_closed = why_not_closed(rebuilt, false).empty();
      std::printf(", rebuilt %+.1e %s", volume_of(rebuilt) / stated - 1,
                  fault.empty() ? "closed" : fault.c_str());
      is_closed = is_closed && std::abs(volume_of(rebuilt) / stated - 1) < 1e-9;
    }
    const bool is_right = wrong_at_any_ == 0 && unknown_at_last_ == 0 && bounds_hold_ &&
                          loosest_bound_ <= 3 && is_closed;
    std::printf("%s\n", is_right ? "" : "  <-- FAILS");
    return is_right ? kExitDone : 1;
  }

 private:
  /// Half of them anywhere in the universe cube, half `nearest` to 1e-2 of the diagonal off the
  /// surface.
  Vec3 point_to_try(bool near) {
    const Universe& universe = tree_.universe;
    const double half = universe.half_side * universe.scale();
    if (!near) {
      return universe.center +
             half * Vec3(random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1));
    }
    const auto sample =
        random_.chance(0.5) ? judge_.sample(random_) : judge_.sample_triangle(random_);
    const double off = std::pow(10.0, random_.between(std::log10(options_.nearest), -2));
    return sample.point + sample.normal * (random_.chance(0.5) ? off : -off) * judge_.diagonal();
  }

  void judge_points() {
    struct Question {
      Vec3 point{0.0};
      PointClass right = PointClass::Out;
      bool was_wrong = false;
    };
    std::vector<Question> questions;
    for (std::size_t i = 0; i < options_.points; ++i) {
      const Vec3 point = point_to_try(i % 2 == 1);
      // What is off one triangle may be on another.
      if (judge_.distance(point) < 0.999 * options_.nearest * judge_.diagonal()) continue;
      questions.push_back({point, judge_.is_inside(point) ? PointClass::In : PointClass::Out});
    }
    judged_ = questions.size();
    const auto last = static_cast<std::uint32_t>(tree_.levels.size() - 1);
    for (std::uint32_t k = 0; k <= last; ++k) {
      const QueryIndex index(tree_, k);
      for (Question& question : questions) {
        const PointClass now = index.classify(tree_.universe.to_universe(question.point));
        if (now == PointClass::Unknown) {
          unknown_at_last_ += k == last;
          continue;
        }
        if (now == question.right) continue;
        wrong_at_last_ += k == last;
        if (question.was_wrong) continue;
        question.was_wrong = true;
        if (++wrong_at_any_ > 3) continue;
        const Vec3 point = question.point;
        std::fprintf(stderr, "%s: level %u says %d of (%.17g %.17g %.17g), %g off the surface\n",
                     options_.mesh.c_str(), k, static_cast<int>(now), point.x, point.y, point.z,
                     judge_.distance(point) / judge_.diagonal());
      }
    }
  }

  /// The error bound against the largest distance that is found by trying and climbing.
  void judge_bounds() {
    for (std::uint32_t k = 0; k + 1 < tree_.levels.size(); ++k) {
      GreyPieces grey;
      WalkOptions walk;
      walk.level = k;
      walk_pieces(tree_, walk, grey);
      if (grey.pieces.empty()) continue;
      const double sampled = sampled_distance(grey.pieces, k);
      const double bound = tree_.levels[k].statement.error_bound;
      const double moved = options_.moved * judge_.diagonal();
      if (bound < sampled - moved) bounds_hold_ = false;
      if (sampled > 10 * moved + 1e-9 * judge_.diagonal()) {
        loosest_bound_ = std::max(loosest_bound_, bound / sampled);
      }
    }
  }

  /// The distance from the solid of a point of model coordinates that is in T_level; 0 for others.
  double distance_in_level(Vec3 point, std::uint32_t level) const {
    const bool may_be =
        classify_point(tree_, tree_.universe.to_universe(point), level) == PointClass::Unknown;
    return may_be && !judge_.is_inside(point) ? judge_.distance(point) : 0;
  }

  /// Points of T_level that are not in the solid are looked for among the corners and mixtures of
  /// corners of its uncertain pieces, and off the solid's surface; from the farthest, others are
  /// tried at shrinking distances.
  double sampled_distance(const std::vector<std::vector<Vec3>>& pieces, std::uint32_t level) {
    struct Place {
      double distance = 0;
      Vec3 point{0.0};
    };
    std::vector<Place> places;
    const auto look_at = [&](Vec3 point) { places.push_back({judge_.distance(point), point}); };
    for (const auto& piece : pieces) {
      Vec3 middle{0.0};
      for (const Vec3 corner : piece) middle += corner / static_cast<double>(piece.size());
      for (const Vec3 corner : piece) {
        look_at(tree_.universe.to_model(glm::mix(corner, middle, 1e-9)));
      }
      for (std::size_t i = 0; i < 1 + 3000 / pieces.size(); ++i) {
        look_at(tree_.universe.to_model(random_mixture(piece, random_)));
      }
    }
    for (int i = 0; i < 6000; ++i) {
      const auto sample = i % 2 ? judge_.sample(random_) : judge_.sample_triangle(random_);
      const double off = std::pow(10.0, random_.between(-6, -1)) * judge_.diagonal();
      look_at(sample.point + off * sample.normal);
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.distance > b.distance; });
    double most = 0;
    int climbs = 0;
    for (const Place& start : places) {
      if (climbs == 20 || (climbs > 5 && start.distance < most / 3)) break;
      Place best = start;
      best.distance = distance_in_level(start.point, level);
      if (best.distance == 0) continue;
      ++climbs;
      double reach = best.distance;
      for (int i = 0; i < 200; ++i) {
        const auto step = [&] { return reach * random_.between(-1, 1); };
        const Vec3 point = best.point + Vec3(step(), step(), step());
        const double distance = distance_in_level(point, level);
        if (distance > best.distance) {
          best = {distance, point};
        } else {
          reach *= 0.96;
        }
        if (i == 100) reach = best.distance / 4;
      }
      most = std::max(most, best.distance);
    }
    return most;
  }

  const Options& options_;
  PlainMesh mesh_;
  MeshJudge judge_;
  Octree tree_;
  Random random_{20261122};
  std::size_t judged_ = 0;
  std::size_t wrong_at_last_ = 0;
  std::size_t wrong_at_any_ = 0;
  std::size_t unknown_at_last_ = 0;
  bool bounds_hold_ = true;
  double loosest_bound_ = 0;
};

}  // namespace

}  // namespace spoctree

int main(int argc, char** argv) {
  CLI::App app("Judges a model by the mesh it was made of", "judge_model");
  spoctree::Options options;
  app.add_option("MESH", options.mesh)->required();
  app.add_option("MODEL", options.model)->required();
  app.add_option("--points", options.points, "Points to classify");
  app.add_option("--moved", options.moved, "The solid may be off the mesh by this (diagonals)");
  app.add_option("--nearest", options.nearest, "Judge no points nearer to the surface (diagonals)");
  app.add_option("--name", options.name, "What to call the mesh (default: its file's name)");
  app.add_option("--rebuilt", options.rebuilt, "The rebuilt boundary, as OFF");
  int verdict = 0;
  app.callback([&] { verdict = spoctree::Judge(options).run(); });
  const int code = spoctree::run_program(app, argc, argv);
  return code != 0 ? code : verdict;
}
