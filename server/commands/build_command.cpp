#include "server/commands/build_command.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <variant>

#include "common/base/atomic_file.hpp"
#include "common/base/errors.hpp"
#include "common/program/output.hpp"
#include "common/program/progress_line.hpp"
#include "common/report/level_rows.hpp"
#include "common/report/model_note.hpp"
#include "common/wire/hash.hpp"
#include "common/wire/spo_file.hpp"
#include "server/commands/build_progress.hpp"
#include "server/commands/describe_solid.hpp"
#include "server/solid/write_off.hpp"

namespace spoctree {

namespace {

std::string summarize(const BuildArguments& arguments, const Model& model, const SpoFile& file) {
  std::string text = describe_solid(arguments.mesh, model.report, model.plane_count, model.volume);
  for (const std::string& change : model.changes) text += change + "\n";
  text += to_table(level_rows(model.tree, file.level_bytes()));
  const bool is_classical = std::holds_alternative<ClassicalRules>(arguments.options.rules);
  char line[256];
  std::snprintf(line, sizeof line, "depth %zu, %u nodes, %zu of them %s\n",
                model.tree.levels.size() - 1, file.info().node_count, model.depth_limited_nodes,
                is_classical ? "mixed cells, full or void by --partial"
                             : "leaves only because of --max-depth");
  text += line;
  text += note_on_levels(file.info().source);
  text += arguments.output + ": model " + to_hex(file.frames_hash()) + ", " +
          std::to_string(file.frames().size()) + " bytes to transmit\n";
  std::snprintf(line, sizeof line, "%.3f s (import %.3f, build %.3f, certify %.3f)\n",
                model.import_seconds + model.build_seconds + model.certify_seconds,
                model.import_seconds, model.build_seconds, model.certify_seconds);
  return text + line;
}

/// Two things in one file would be one of them lost: at worst the user's mesh.
void require_different_files(const BuildArguments& arguments) {
  const auto require = [](const std::string& a, const std::string& b, const char* what) {
    if (are_one_file(a, b)) throw UsageError(b + ": " + what);
  };
  require(arguments.mesh, arguments.output, "--output is the mesh itself");
  if (arguments.save_solid.empty()) return;
  require(arguments.mesh, arguments.save_solid, "--save-solid is the mesh itself");
  require(arguments.output, arguments.save_solid, "--save-solid and --output are the same");
}

}  // namespace

void run_build(const BuildArguments& arguments) {
  require_different_files(arguments);
  ProgressLine line;
  // It gets its name together with the model: a build that is broken off leaves neither.
  std::optional<AtomicFile> solid_file;
  const auto save = [&](const Solid& solid) {
    if (arguments.save_solid == "-") {
      print(to_off(solid));
    } else if (!arguments.save_solid.empty()) {
      solid_file.emplace(arguments.save_solid);
      solid_file->write(to_off(solid));
    }
  };
  const Model model =
      build_model(arguments.mesh, arguments.options, show_progress(line, arguments.mesh), save);
  const SpoFile file(model.spo, arguments.output);
  write_output(arguments.output, model.spo);
  if (solid_file) solid_file->commit();
  line.clear();
  const std::string summary = summarize(arguments, model, file);
  if (arguments.output == "-") {
    std::fputs(summary.c_str(), stderr);
  } else {
    print(summary);
  }
}

}  // namespace spoctree
