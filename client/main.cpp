// spoctree-client: sockets and .spo files -> trees, level by level -> tables, meshes, drawings.

#include <CLI/CLI.hpp>
#include <string>

#include "client/commands/commands.hpp"
#include "client/commands/draw_options.hpp"
#include "client/commands/parse_level.hpp"
#include "common/base/errors.hpp"
#include "common/program/run_program.hpp"
#include "common/program/threads.hpp"

namespace {

using namespace spoctree;

constexpr const char* kFooter =
    "SOURCE is spo://HOST:PORT/NAME or a .spo file. In NAME, %XX is the byte with that number (%20\n"
    "a blank, %25 a %); it may be left out where the server has one model only.\n"
    "Exit codes: 0 done; 2 wrong usage (also: a level beyond the last one); 3 bad input (a file "
    "or\n"
    "a stream is not what it should be, there is no such model or file, a file cannot be "
    "written);\n"
    "4 network (no connection, a silent server, a transmission broken off, a server that is busy).";

CLI::App& add_stream_command(CLI::App& app, const char* name, const char* description,
                             StreamOptions& options) {
  CLI::App& command = *app.add_subcommand(name, description);
  command.add_option("SOURCE", options.source, "spo://HOST:PORT/NAME or a .spo file")->required();
  command
      .add_option("--rate", options.rate,
                  "bytes per second, at most: to see how a model arrives over a slow link")
      ->check(CLI::Range(kLowestRate, std::uint64_t{1} << 40));
  return command;
}

CLI::App& add_ask_command(CLI::App& app, const char* name, const char* description,
                          AskArguments& arguments, std::string& level) {
  CLI::App& command = add_stream_command(app, name, description, arguments.stream);
  command.add_option("QUESTIONS", arguments.questions,
                     "a file of such lines, in model coordinates; left out or -: standard input. "
                     "Empty lines and lines that begin with # get no answer");
  command.add_option("--level", level,
                     "which level answers, as soon as it is there; left out: the last one");
  command.add_flag("--follow", arguments.follow,
                   "read all questions, then answer each with the first level that can, while the "
                   "levels arrive: lines \"LEVEL LINE ANSWER\"");
  return command;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Receives SP-Octrees level by level, and shows what has arrived.",
               "spoctree-client");
  app.require_subcommand(1);
  app.footer(kFooter);

  ListArguments list;
  CLI::App& list_command = *app.add_subcommand("list", "the models of a server");
  list_command.add_option("SERVER", list.server, "spo://HOST:PORT")->required();
  list_command.callback([&] { run_list(list); });

  FetchArguments fetch;
  std::uint32_t fetch_levels = 0;
  CLI::App& fetch_command =
      add_stream_command(app, "fetch", "receive a model into a .spo file", fetch.stream);
  fetch_command
      .add_option("-o,--output", fetch.output,
                  "the .spo file; with all levels it is the server's file, byte for byte")
      ->required();
  fetch_command.add_option("--levels", fetch_levels, "only the first so many levels")
      ->check(CLI::Range(std::uint32_t{1}, kMaxLevels));
  fetch_command.add_flag("--resume", fetch.resume,
                         "go on after the whole levels that are in the output already; if the "
                         "transmission breaks off, keep those that have arrived");
  fetch_command.callback([&] {
    if (fetch_levels > 0) fetch.stream.last_level = fetch_levels - 1;
    run_fetch(fetch);
  });

  LevelsArguments levels;
  CLI::App& levels_command = add_stream_command(
      app, "levels", "what each level holds and costs; errors in % of the universe cube's diagonal",
      levels.stream);
  bool as_json = false;
  bool as_csv = false;
  CLI::Option* const json = levels_command.add_flag("--json", as_json, "one JSON object");
  levels_command.add_flag("--csv", as_csv, "comma-separated values")->excludes(json);
  levels_command.callback([&] {
    if (as_json) levels.format = LevelsArguments::Format::Json;
    if (as_csv) levels.format = LevelsArguments::Format::Csv;
    run_levels(levels);
  });

  RebuildArguments rebuild;
  std::string rebuild_level;
  CLI::App& rebuild_command = add_stream_command(
      app, "rebuild", "the boundary of a level's solid, as a mesh of polygons", rebuild.stream);
  rebuild_command.add_option("-o,--output", rebuild.output, "an OFF file; - is standard output")
      ->required();
  rebuild_command.add_option("--level", rebuild_level, "which level; left out: the last one");
  ThreadsOption rebuild_threads(rebuild_command);
  rebuild_command.callback([&] {
    rebuild_threads.apply();
    if (!rebuild_level.empty()) rebuild.stream.last_level = parse_level(rebuild_level);
    run_rebuild(rebuild);
  });

  StreamOptions draw_stream;
  CLI::App& draw_command =
      add_stream_command(app, "draw", "line drawings of levels, hidden lines removed", draw_stream);
  const DrawOptions draw(draw_command, draw_stream);
  ThreadsOption draw_threads(draw_command);
  draw_command.callback([&] {
    draw_threads.apply();
    run_draw(draw.arguments());
  });

  AskArguments classify;
  std::string classify_level;
  CLI::App& classify_command = add_ask_command(
      app, "classify",
      "where points lie: lines \"x y z\" in, lines `in`, `out`, `on` (the boundary) or `unknown` "
      "(at this level; never at the last) out",
      classify, classify_level);
  classify_command.callback([&] {
    if (!classify_level.empty()) classify.stream.last_level = parse_level(classify_level);
    run_classify(classify);
  });

  AskArguments ray;
  std::string ray_level;
  CLI::App& ray_command = add_ask_command(
      app, "ray",
      "where rays first cross the boundary: lines \"ox oy oz dx dy dz\" in, lines `hit t nx ny nz` "
      "(at o + t d, with the outward normal), `miss`, or `between t0 t1` (not before t0; t1 is inf "
      "if the ray may miss) out; a ray that starts inside hits where it leaves",
      ray, ray_level);
  ray_command.callback([&] {
    if (!ray_level.empty()) ray.stream.last_level = parse_level(ray_level);
    run_ray(ray);
  });

  MeasureArguments measure;
  std::string measure_level;
  CLI::App& measure_command = add_stream_command(
      app, "measure",
      "volume, surface area and bounding box, exact at the last level, with bounds that hold for "
      "certain before; and the numbers of components and cavities",
      measure.stream);
  measure_command.add_option("--level", measure_level, "which level; left out: the last one");
  measure_command.add_flag("--json", measure.as_json, "one JSON object");
  measure_command.callback([&] {
    if (!measure_level.empty()) measure.stream.last_level = parse_level(measure_level);
    run_measure(measure);
  });

  return run_program(app, argc, argv);
}
