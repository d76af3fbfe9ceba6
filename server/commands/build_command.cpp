#include "server/commands/build_command.hpp"

#include <cstdio>

#include "common/program/output.hpp"
#include "common/program/progress_line.hpp"
#include "common/report/level_rows.hpp"
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
  char line[256];
  std::snprintf(line, sizeof line,
                "depth %zu, %u nodes, %zu of them leaves only because of --max-depth\n",
                model.tree.levels.size() - 1, file.info().node_count, model.depth_limited_nodes);
  text += line;
  text += arguments.output + ": model " + to_hex(file.frames_hash()) + ", " +
          std::to_string(file.frames().size()) + " bytes to transmit\n";
  std::snprintf(line, sizeof line, "%.3f s (import %.3f, build %.3f, certify %.3f)\n",
                model.import_seconds + model.build_seconds + model.certify_seconds,
                model.import_seconds, model.build_seconds, model.certify_seconds);
  return text + line;
}

}  // namespace

void run_build(const BuildArguments& arguments) {
  ProgressLine line;
  const auto save = [&](const Solid& solid) {
    if (!arguments.save_solid.empty()) write_output(arguments.save_solid, to_off(solid));
  };
  const Model model =
      build_model(arguments.mesh, arguments.options, show_progress(line, arguments.mesh), save);
  const SpoFile file(model.spo, arguments.output);
  write_output(arguments.output, model.spo);
  line.clear();
  const std::string summary = summarize(arguments, model, file);
  if (arguments.output == "-") {
    std::fputs(summary.c_str(), stderr);
  } else {
    print(summary);
  }
}

}  // namespace spoctree
