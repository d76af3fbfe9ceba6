#include <algorithm>
#include <cstdio>
#include <optional>
#include <vector>

#include "client/cells/cell_scene.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/draw_formats.hpp"
#include "client/commands/draw_warnings.hpp"
#include "client/commands/drawing_output.hpp"
#include "client/lines/visible_lines.hpp"
#include "client/rebuild/surface_rebuilder.hpp"
#include "common/base/errors.hpp"
#include "common/base/give_back_memory.hpp"
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

double least_angle_of(const DrawArguments& arguments) {
  return arguments.crease_angle_deg.value_or(kDraughtsmanCreaseAngleDeg);
}

/// What is kept from level to level.
struct Drawn {
  SurfaceRebuilder rebuilder;
  std::optional<LineScene> scene;
};

/// Shows how much of a level is drawn, and ends that when the user does not want it any more.
class LevelProgress {
 public:
  LevelProgress(LevelStream& stream, const std::string& model)
      : line_(stream.progress_line()),
        model_(model),
        level_(std::to_string(stream.level())),
        report_([this](double fraction) { report(fraction); }) {}

  /// The next step, of this share of all.
  ProgressShare begin(const char* step, double share) {
    step_ = step;
    begin_ = end_;
    end_ += share;
    check();
    show(begin_);
    return ProgressShare(meter_, share);
  }

 private:
  /// By any thread, one at a time.
  void report(double fraction) {
    check();
    // Some of a step before may have been nothing to do.
    if (line_.wants_text()) show(std::max(fraction, begin_));
  }
  void check() const {
    if (Interruption::is_requested()) throw NetworkError(model_ + ": interrupted");
  }
  void show(double fraction) {
    line_.show(step_ + (" level " + level_) + " " +
               describe_progress(fraction, elapsed_.seconds()));
  }

  ProgressLine& line_;
  const std::string model_;
  const std::string level_;
  std::string step_;
  double begin_ = 0;  // of the step
  double end_ = 0;
  Elapsed elapsed_;
  const ProgressReport report_;
  ProgressMeter meter_{report_};
};

/// What a level took, for --statistics.
struct DrawingCosts {
  double preparing_s = 0;
  double drawing_s = 0;
  std::vector<AvenueCounts> avenues;  ///< of each view
};

void print_costs(const LevelPictures& level, const DrawingCosts& costs,
                 const std::optional<CellScene>& cells) {
  std::string text = "level " + std::to_string(level.level) + ": ";
  char times[80];
  std::snprintf(times, sizeof times, "prepared in %.4f s, drawn in %.4f s", costs.preparing_s,
                costs.drawing_s);
  text += times;
  if (cells) {
    const EmptySpace& space = cells->space();
    text += "; " + std::to_string(space.cells().size()) + " cells (" +
            std::to_string(space.cells_of_partition()) + " before merging), " +
            std::to_string(space.openings().openings.size()) + " openings";
    for (const AvenueCounts& counts : costs.avenues) {
      text += "; " + std::to_string(counts.avenues) + " avenues into " +
              std::to_string(counts.cells) + " cells, through up to " +
              std::to_string(counts.longest) + " openings";
    }
  }
  std::fprintf(stderr, "spoctree-client: %s\n", text.c_str());
}

/// Afterwards, no further level can be drawn if this is the last one.
LevelPictures draw_level(LevelStream& stream, Drawn& drawn, const std::vector<View>& views,
                         const DrawArguments& arguments, bool is_last) {
  const Octree& tree = stream.tree();
  LevelPictures level;
  level.model = clean_text(stream.model_name(), kLongestTitle);
  level.level = stream.level();
  level.universe = tree.universe;
  level.pictures.resize(views.size());
  LevelProgress progress(stream, level.model);
  const bool with_cells = arguments.method == DrawArguments::Method::Cells;
  // The work, where there are a million faces: a view is a fourth of rebuilding, or of preparing.
  const double per_view = 1 / ((with_cells ? 16 : 8) + static_cast<double>(views.size()));
  DrawingCosts costs;
  costs.avenues.resize(views.size());
  std::optional<CellScene> cells;
  {
    const Surface surface =
        drawn.rebuilder.rebuild(tree, level.level, progress.begin("rebuilding", 4 * per_view));
    if (is_last) drawn.rebuilder = {};
    give_back_memory();
    const ProgressShare preparing = progress.begin("preparing", 4 * per_view);
    const Elapsed elapsed;
    if (drawn.scene) {
      drawn.scene->go_on_to(surface, level.level, preparing);
    } else {
      drawn.scene.emplace(tree, surface, level.level, preparing);
    }
    costs.preparing_s = elapsed.seconds();
  }
  give_back_memory();
  if (with_cells) {
    const ProgressShare dividing = progress.begin("dividing space", 8 * per_view);
    const Elapsed elapsed;
    cells.emplace(*drawn.scene, dividing);
    costs.preparing_s = elapsed.seconds();
  }
  const ProgressShare drawing =
      progress.begin("drawing", per_view * static_cast<double>(views.size()));
  const Elapsed elapsed;
  parallel_for(views.size(), [&](std::size_t k) {
    LineOptions options;
    options.crease_angle_deg = least_angle_of(arguments);
    options.with_hidden_lines = arguments.with_hidden_lines;
    options.split_by_source = arguments.colour_by_kind;
    options.frame = with_border(views[k].frame);
    options.with_silhouettes = arguments.with_silhouettes;
    options.with_creases = arguments.with_creases;
    options.with_steps = arguments.with_steps;
    options.progress = drawing.part(per_item(views.size()));
    if (cells) options.find_seen_parts = cells->finder(&costs.avenues[k]);
    level.pictures[k] =
        make_picture(views[k], visible_lines(*drawn.scene, views[k].camera, options));
  });
  costs.drawing_s = elapsed.seconds();
  progress.begin("writing", 0);
  if (arguments.with_statistics) print_costs(level, costs, cells);
  cells.reset();
  if (is_last) drawn.scene.reset();
  return level;
}

void draw_levels(const DrawArguments& arguments, DrawingFiles& files, DrawingPage& page) {
  LevelStream stream(arguments.stream);
  Drawn drawn;
  std::vector<View> views;
  const bool keeps_levels = arguments.all_levels || page.is_wanted();
  const auto draw = [&] {
    const bool is_last = !keeps_levels || stream.tree().is_complete();
    return draw_level(stream, drawn, views, arguments, is_last);
  };
  LevelPictures last;
  // While a level is drawn, the next one waits in the socket.
  while (stream.next_level()) {
    // The first level says how large the model is: views are the same for all levels.
    if (views.empty()) views = make_views(arguments.view, stream.tree());
    if (!keeps_levels) continue;
    last = draw();
    if (arguments.all_levels) files.add(last);
    if (page.is_wanted()) page.add(last, stream);
  }
  if (!arguments.all_levels && !page.is_wanted()) last = draw();
  if (!arguments.all_levels) files.add(last);
  stream.progress_line().clear();
  const bool leaves_creases_out = arguments.with_creases && least_angle_of(arguments) > 0;
  for (const std::string& warning : warnings_of(last, stream.tree(), leaves_creases_out))
    std::fprintf(stderr, "spoctree-client: %s\n", warning.c_str());
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
