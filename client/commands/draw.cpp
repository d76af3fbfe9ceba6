#include <charconv>
#include <filesystem>

#include "client/commands/commands.hpp"
#include "client/commands/level_files.hpp"
#include "client/draw/drawing.hpp"
#include "client/draw/write_json.hpp"
#include "client/draw/write_svg.hpp"
#include "client/lines/camera.hpp"
#include "client/lines/extent.hpp"
#include "client/lines/visible_lines.hpp"
#include "client/rebuild/surface.hpp"
#include "common/base/errors.hpp"
#include "common/program/output.hpp"

namespace spoctree {

namespace {

Camera parse_camera(const std::string& text) {
  if (text.empty()) return {};
  Vec3 direction{0.0};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int axis = 0; axis < 3; ++axis) {
    const auto [stop, error] = std::from_chars(at, end, direction[axis]);
    const bool is_last = axis == 2;
    if (error != std::errc() || (is_last ? stop != end : stop == end || *stop != ','))
      throw UsageError("--from: '" + text + "' should be three numbers X,Y,Z");
    at = stop + (is_last ? 0 : 1);
  }
  return Camera(direction);
}

std::string choose_format(const DrawArguments& arguments) {
  if (!arguments.format.empty()) return arguments.format;
  return std::filesystem::path(arguments.output).extension() == ".json" ? "json" : "svg";
}

std::string draw(const LevelStream& stream, const Camera& camera, double crease_angle_deg,
                 const std::string& format) {
  const Octree& tree = stream.tree();
  LineOptions options;
  options.level = stream.level();
  options.crease_angle_deg = crease_angle_deg;
  const VisibleLines lines =
      visible_lines(tree, rebuild_surface(tree, options.level), camera, options);
  if (format == "json") return to_json(lines, tree.universe, options.level);
  PageOptions page;
  page.frame = extent_of_solid(tree, camera);
  SvgStyle style;
  style.title = stream.model_name() + ", level " + std::to_string(options.level);
  return to_svg(make_drawing(lines, camera, page), style);
}

}  // namespace

void run_draw(const DrawArguments& arguments) {
  const Camera camera = parse_camera(arguments.from);
  const std::string format = choose_format(arguments);
  const LevelFiles files(arguments.output, arguments.all_levels, "." + format);
  LevelStream stream(arguments.stream);
  const auto draw_level = [&] {
    stream.progress_line().show("drawing level " + std::to_string(stream.level()));
    write_output(files.name_of(stream.level()),
                 draw(stream, camera, arguments.crease_angle_deg, format));
  };
  // While a level is drawn, the next one waits in the socket.
  while (stream.next_level()) {
    if (arguments.all_levels) draw_level();
  }
  if (!arguments.all_levels) draw_level();
}

}  // namespace spoctree
