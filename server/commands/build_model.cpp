#include "server/commands/build_model.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/hash.hpp"
#include "common/wire/mapped_file.hpp"
#include "common/wire/spo_writer.hpp"
#include "server/build/build_octree.hpp"
#include "server/build/certify.hpp"
#include "server/commands/describe_solid.hpp"
#include "server/commands/tree_options.hpp"
#include "server/mesh/read_mesh.hpp"
#include "server/solid/import_solid.hpp"
#include "server/solid/repair.hpp"

namespace spoctree {

namespace {

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - begin_;
    begin_ = now;
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

SourceInfo describe_source(const std::filesystem::path& mesh, const ModelOptions& options,
                           const SolidReport& report) {
  SourceInfo source;
  source.name = mesh.filename().string();
  source.hash = hash_bytes(MappedFile(mesh).bytes());
  source.build_options = describe_rules(options.rules) + " " +
                         flat_tolerance_options(report.flat_tolerance) +
                         (options.repair ? " repair" : "");
  return source;
}

/// The steps of a build. The shares are those of a million faces on two cores.
struct Step {
  const char* name;
  double begin;
  double end;
};
constexpr Step kReading{"reading", 0, 0.04};
constexpr Step kJudging{"judging", kReading.end, 0.24};
constexpr Step kBuilding{"building", kJudging.end, 0.80};
constexpr Step kCertifying{"certifying", kBuilding.end, 0.92};
constexpr Step kEncoding{"encoding", kCertifying.end, 1};

ProgressReport report_of(const Step& step, const BuildProgress& progress) {
  return [&step, &progress](double fraction) {
    progress(step.name, step.begin + fraction * (step.end - step.begin));
  };
}

// Reads and judges the faces, repaired if that is wanted.
Solid read_solid(const std::filesystem::path& mesh, const ModelOptions& options,
                 const BuildProgress& progress, std::vector<std::string>& changes) {
  progress(kReading.name, kReading.begin);
  PolygonSoup soup = read_mesh(mesh);
  const std::vector<std::string> remarks = std::move(soup.remarks);
  if (soup.collapsed.count > 0) {
    changes.push_back("dropped: " + std::to_string(soup.collapsed.count) +
                      " faces with fewer than three different corners, the first is face " +
                      std::to_string(soup.collapsed.first) + " (counted from 0)");
  }
  ImportOptions import_options;
  import_options.flat_tolerance = options.flat_tolerance;
  import_options.turn_shells = options.repair;
  import_options.may_touch_itself = options.repair;
  import_options.progress = report_of(kJudging, progress);
  import_options.progress(0);
  std::string refusals;
  if (options.repair) {
    Repair repaired = repair(std::move(soup));
    soup = std::move(repaired.soup);
    changes.insert(changes.end(), repaired.changes.begin(), repaired.changes.end());
    for (const std::string& refusal : repaired.refusals) {
      refusals += (refusals.empty() ? " (" : "; ") + refusal;
    }
    if (!refusals.empty()) refusals += ")";
  }
  // Of the file itself it need not be true any more.
  std::string name = mesh.string();
  if (!changes.empty()) name += options.repair ? ", after repair" : ", without its collapsed faces";
  changes.insert(changes.begin(), remarks.begin(), remarks.end());
  for (const std::string& remark : remarks) refusals.append(" (").append(remark).append(")");
  try {
    Solid solid = import_solid(std::move(soup), name, import_options);
    changes.insert(changes.end(), solid.report.settled.begin(), solid.report.settled.end());
    if (const std::size_t turned = solid.report.turned_shells; turned > 0) {
      changes.push_back("turned: " + std::to_string(turned) +
                        (turned == 1 ? " shell that faced" : " shells that faced") +
                        " the wrong way for how the shells nest");
    }
    return solid;
  } catch (const UnsoundSurface& error) {
    throw BadInput(error.what() + std::string(options.repair ? "" : " (--repair may mend it)") +
                   refusals);
  } catch (const BadInput& error) {
    throw BadInput(error.what() + refusals);
  }
}

BuiltOctree build_tree(const Solid& solid, const SolidQueries& queries, const BuildOptions& options,
                       const std::filesystem::path& mesh) {
  try {
    return build_octree(solid, queries, options);
  } catch (const BadInput& error) {
    throw BadInput(mesh.string() + ": " + error.what());
  }
}

}  // namespace

Model build_model(const std::filesystem::path& mesh, const ModelOptions& options,
                  const BuildProgress& progress, const SolidObserver& observe) {
  Model model;
  Stopwatch stopwatch;
  const Solid solid = read_solid(mesh, options, progress, model.changes);
  model.report = solid.report;
  model.plane_count = solid.planes.size();
  model.volume = solid.volume;
  model.import_seconds = stopwatch.lap();
  if (observe) observe(solid);
  stopwatch.lap();

  BuildOptions build_options;
  build_options.rules = options.rules;
  build_options.progress = report_of(kBuilding, progress);
  build_options.progress(0);
  const SolidQueries queries(solid);
  BuiltOctree built = build_tree(solid, queries, build_options, mesh);
  model.build_seconds = stopwatch.lap();

  certify(built, solid, queries, report_of(kCertifying, progress));
  model.certify_seconds = stopwatch.lap();

  model.depth_limited_nodes = built.depth_limited_nodes;
  model.tree = std::move(built.tree);
  progress(kEncoding.name, kEncoding.begin);
  const auto broken = validate(model.tree, 1);
  if (!broken.empty()) {
    throw std::logic_error(mesh.string() + ": the program has built an invalid tree (" +
                           broken.front() + "): please report this");
  }
  model.spo = encode_spo(model.tree, describe_source(mesh, options, model.report));
  return model;
}

}  // namespace spoctree
