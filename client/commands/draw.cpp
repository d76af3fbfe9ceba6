#include <cstdio>
#include <optional>
#include <vector>

#include "client/commands/commands.hpp"
#include "client/commands/draw_formats.hpp"
#include "client/commands/drawing_output.hpp"
#include "client/lines/visible_lines.hpp"
#include "client/rebuild/surface_rebuilder.hpp"
#include "common/base/errors.hpp"
#include "common/base/interruption.hpp"
#include "common/base/parallel.hpp"
#include "common/wire/text.hpp"

namespace spoctree {

namespace {

/// Lines on the border of a frame are in it for certain, however they are rounded.
Rectangle with_border(const Rectangle& frame) {
  const Vec2 border = 1e-6 * (frame.upper - frame.lower);
  return {frame.lower - border, frame.upper + border};
}

/// What is kept from level to level.
struct Drawn {
  SurfaceRebuilder rebuilder;
  std::optional<LineScene> scene;
};

LevelPictures draw_level(LevelStream& stream, Drawn& drawn, const std::vector<View>& views,
                         const DrawArguments& arguments) {
  const Octree& tree = stream.tree();
  LevelPictures level;
  level.model = clean_text(stream.model_name(), kLongestTitle);
  level.level = stream.level();
  level.universe = tree.universe;
  level.pictures.resize(views.size());
  const auto start = [&](const char* step) {
    if (Interruption::is_requested()) throw NetworkError(level.model + ": interrupted");
    stream.progress_line().show(step + (" level " + std::to_string(level.level)));
  };
  start("rebuilding");
  const Surface surface = drawn.rebuilder.rebuild(tree, level.level);
  start("preparing");
  if (drawn.scene) {
    drawn.scene->go_on_to(surface, level.level);
  } else {
    drawn.scene.emplace(tree, surface, level.level);
  }
  start("drawing");
  parallel_for(views.size(), [&](std::size_t k) {
    LineOptions options;
    options.crease_angle_deg = arguments.crease_angle_deg;
    options.with_hidden_lines = arguments.with_hidden_lines;
    options.split_by_source = arguments.colour_by_kind;
    options.frame = with_border(views[k].frame);
    options.with_silhouettes = arguments.with_silhouettes;
    options.with_creases = arguments.with_creases;
    options.with_steps = arguments.with_steps;
    level.pictures[k] =
        make_picture(views[k], visible_lines(*drawn.scene, views[k].camera, options));
  });
  return level;
}

void draw_levels(const DrawArguments& arguments, DrawingFiles& files, DrawingPage& page) {
  LevelStream stream(arguments.stream);
  Drawn drawn;
  std::vector<View> views;
  const auto draw = [&] { return draw_level(stream, drawn, views, arguments); };
  LevelPictures last;
  // While a level is drawn, the next one waits in the socket.
  while (stream.next_level()) {
    // The first level says how large the model is: views are the same for all levels.
    if (views.empty()) views = make_views(arguments.view, stream.tree());
    if (!arguments.all_levels && !page.is_wanted()) continue;
    last = draw();
    if (arguments.all_levels) files.add(last);
    if (page.is_wanted()) page.add(last, stream);
  }
  if (!arguments.all_levels) files.add(page.is_wanted() ? last : draw());
}

}  // namespace

void run_draw(const DrawArguments& arguments) {
  check(arguments);
  DrawingFiles files(arguments);
  DrawingPage page(arguments);
  {
    // A signal is a broken transmission like others, where there are levels to be kept.
    std::optional<Interruption> interruption;
    if (files.is_document() || page.is_wanted()) interruption.emplace();
    auto finish = [&, is_finished = false]() mutable {
      if (is_finished) return;
      is_finished = true;
      files.finish();
      page.finish();
    };
    try {
      draw_levels(arguments, files, page);
    } catch (const NetworkError& error) {
      finish();
      if (!Interruption::is_requested()) throw;
      std::fprintf(stderr, "spoctree-client: %s\n", error.what());
    } catch (const BadInput&) {
      finish();
      throw;
    }
    finish();
  }
  Interruption::go_on();
}

}  // namespace spoctree
