// spoctree-server: mesh files -> SP-Octrees -> .spo files -> sockets.

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <string>

#include "common/program/run_program.hpp"
#include "common/program/threads.hpp"
#include "server/commands/build_command.hpp"
#include "server/commands/info_command.hpp"
#include "server/commands/serve_command.hpp"
#include "server/commands/tree_options.hpp"

namespace {

using namespace spoctree;

constexpr const char* kMeshFormats = "Mesh files are OFF, OBJ, STL and PLY (text and binary).";

/// For CLI11, whose ranges let NaN pass.
std::string is_number(const std::string& text) {
  const double value = std::strtod(text.c_str(), nullptr);
  return std::isnan(value) ? "'" + text + "' is not a number" : "";
}

void add_model_options(CLI::App& command, ModelOptions& options) {
  add_tree_options(command, options.rules);
  command
      .add_option("--flat-tolerance", options.flat_tolerance,
                  "neighbouring faces that are flat within so much of the diagonal become one, and "
                  "corners move by less than twice that; 0 keeps every plane. Unless given, 1e-6, "
                  "or where the file's coordinates are rounded more coarsely, what that explains")
      ->check(CLI::Range(0.0, kLargestFlatTolerance) & CLI::Validator(is_number, "NUMBER"));
  command.add_flag(
      "--repair", options.repair,
      "drop copies of faces and triangles without area, turn faces that disagree, fill "
      "holes, make one solid of parts that touch or overlap; every change is said");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Builds octrees from meshes and serves them, level by level.", "spoctree-server");
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 2 wrong usage, 3 bad input (a file that is not what it should be, or\n"
      "cannot be read or written), 4 network (the address cannot be listened on).");

  BuildArguments build;
  CLI::App& build_command = *app.add_subcommand("build", "build a .spo file from a mesh");
  build_command.add_option("MESH", build.mesh, kMeshFormats)->required();
  build_command.add_option("-o,--output", build.output, "the .spo file; - is standard output")
      ->required();
  build_command.add_option(
      "--save-solid", build.save_solid,
      "also write the solid that the model is of, in triangles, to this OFF file");
  add_model_options(build_command, build.options);
  ThreadsOption build_threads(build_command);
  build_command.callback([&] {
    build_threads.apply();
    run_build(build);
  });

  ServeArguments serve;
  CLI::App& serve_command = *app.add_subcommand(
      "serve", "serve models until SIGTERM; a model is called like its file, without extension");
  serve_command
      .add_option("FILE", serve.paths,
                  ".spo files, meshes (built first), and folders of both: every .spo file and mesh "
                  "right in the folder; a mesh beside a .spo file of its name is not built "
                  "again, and what turns out not to be a model is left out, and said")
      ->required();
  serve_command
      .add_option("--listen", serve.listen,
                  "HOST:PORT; port 0 is any free one; a line on standard output says which")
      ->capture_default_str();
  add_model_options(serve_command, serve.options);
  ThreadsOption serve_threads(serve_command);
  serve_command.callback([&] {
    serve_threads.apply();
    run_serve(serve);
  });

  InfoArguments info;
  CLI::App& info_command = *app.add_subcommand("info", "say what a .spo file or a mesh holds");
  info_command.add_option("FILE", info.file, "a .spo file or a mesh")->required();
  info_command.add_flag("--json", info.as_json, "one JSON object");
  info_command.callback([&] { run_info(info); });

  return run_program(app, argc, argv);
}
