#include "client/commands/draw_options.hpp"

#include <CLI/CLI.hpp>

#include "client/commands/parse_level.hpp"
#include "common/base/errors.hpp"
#include "common/base/parse_number.hpp"

namespace spoctree {

namespace {

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  while (true) {
    const std::size_t comma = text.find(',', begin);
    words.push_back(text.substr(begin, comma - begin));
    if (comma == std::string::npos) return words;
    begin = comma + 1;
  }
}

double parse_number(const std::string& text, const std::string& option, const std::string& what) {
  const ParsedReal number = parse_real(text);
  if (number.fault != nullptr) throw UsageError(option + ": '" + text + "' should be " + what);
  return number.value;
}

std::optional<Vec3> parse_vector(const std::string& text, const std::string& option) {
  if (text.empty()) return std::nullopt;
  const std::vector<std::string> words = split(text);
  Vec3 vector{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const ParsedReal number = words.size() == 3 ? parse_real(words[k]) : ParsedReal{0, "missing"};
    if (number.fault != nullptr)
      throw UsageError(option + ": '" + text + "' should be three numbers X,Y,Z");
    vector[axis] = number.value;
  }
  return vector;
}

}  // namespace

struct DrawOptions::Texts {
  std::string level, from, eye, target, up, fov, views, projection, stereo, eye_separation, scale,
      page, lines, hidden = "none", colour_by = "none", crease_angle, dpi, format, output, html,
                   method = "front-to-back";
  bool bare = false;
  bool statistics = false;
};

DrawOptions::DrawOptions(CLI::App& command, StreamOptions& stream)
    : stream_(stream), texts_(std::make_unique<Texts>()) {
  Texts& texts = *texts_;
  command.add_option("-o,--output", texts.output,
                     "a file, or - for standard output; any number of levels: a folder (files "
                     "level-00.svg, level-01.svg, ...), a name with %d or %02d for the level, or "
                     "one PDF file with a page per level");
  command.add_option("--html", texts.html,
                     "one page that shows every level as it arrived; when the transmission breaks "
                     "off, those that have arrived");
  command.add_option("--format", texts.format,
                     "svg, pdf, png, dxf, hpgl or json; left out: as the output's extension says, "
                     "or else svg");
  command.add_option("--level", texts.level,
                     "which level, or `all`: each is drawn before the next one is received; left "
                     "out: the last one");

  const char* const views = "Where the viewer is";
  command
      .add_option("--view", texts.views,
                  "front, back, left, right, top, bottom or iso; several, separated by commas, "
                  "make a sheet at one scale")
      ->group(views);
  command
      .add_option("--projection", texts.projection,
                  "first or third: the angle by which such a sheet is arranged; left out: first, "
                  "as ISO 128 has it")
      ->check(CLI::IsMember({"first", "third"}))
      ->group(views);
  command.add_option("--from", texts.from, "X,Y,Z: a parallel projection, from this direction")
      ->group(views);
  command
      .add_option("--eye", texts.eye,
                  "X,Y,Z: a perspective, from this point in model coordinates; it may be inside "
                  "the model")
      ->group(views);
  command
      .add_option("--target", texts.target,
                  "X,Y,Z: where the eye looks; left out: the middle of the model")
      ->group(views);
  command.add_option("--up", texts.up, "X,Y,Z: what is upwards; left out: +Z")->group(views);
  command
      .add_option("--fov", texts.fov,
                  "DEGREES: how wide the eye's square picture is; left out: as wide as the model")
      ->group(views);
  command
      .add_flag("--stereo{beside}", texts.stereo,
                "what each eye sees, side by side for free viewing; --stereo=anaglyph: in one "
                "picture, for red/cyan glasses (red on the left)")
      ->group(views);
  command
      .add_option("--eye-separation", texts.eye_separation,
                  "for --stereo: how far the eyes are apart, as a fraction of the distance to "
                  "the target; left out: a thirtieth")
      ->group(views);

  const char* const lines = "What is drawn";
  command
      .add_option("--lines", texts.lines,
                  "which of silhouette,crease,step (the steps of cells that later levels "
                  "refine); left out: all")
      ->group(lines);
  command
      .add_option("--crease-angle", texts.crease_angle,
                  "DEGREES: leave out edges at which the faces turn by less, but for silhouettes "
                  "and steps; 0: every edge, facets too; left out: 20")
      ->group(lines);
  command.add_option("--hidden", texts.hidden, "none, or dashed: lines behind material")
      ->check(CLI::IsMember({"none", "dashed"}))
      ->group(lines);
  command
      .add_option("--colour-by,--color-by", texts.colour_by,
                  "none, or kind: grey for planes of GREY nodes, green CONVEX, blue CONCAVE; "
                  "yellow and red: planes of upper levels in CONCAVE and CONVEX nodes; purple "
                  "VERTEX")
      ->check(CLI::IsMember({"none", "kind"}))
      ->group(lines);
  command
      .add_flag("--bare", texts.bare,
                "without each line's planes, level and node kind: smaller files with longer "
                "strokes and a layer per class of lines")
      ->group(lines);

  command
      .add_option("--method", texts.method,
                  "how hidden lines are found: front-to-back (a walk over the tree's pieces of "
                  "material), or cells (avenues of sight through the empty cells between them); "
                  "the picture is the same")
      ->check(CLI::IsMember({"front-to-back", "cells"}))
      ->group(lines);
  command
      .add_flag("--statistics", texts.statistics,
                "say on standard error how long preparing and drawing took, and with --method "
                "cells how many cells, openings and avenues there are")
      ->group(lines);

  const char* const page = "The page";
  command
      .add_option("--scale", texts.scale,
                  "millimetres per model unit, as a number or as 1:50; left out: as large as "
                  "fits (DXF: 1)")
      ->group(page);
  command
      .add_option("--page", texts.page,
                  "A0 to A6, or WIDTHxHEIGHT in millimetres; left out: as large as the drawing, "
                  "200 mm without --scale")
      ->group(page);
  command.add_option("--dpi", texts.dpi, "for PNG: pixels per inch of the page; left out: 200")
      ->group(page);

  // An empty text stands for an option that was left out: nobody may give one.
  const CLI::Validator not_empty(
      [](const std::string& text) { return text.empty() ? "a value is missing" : std::string(); },
      "");
  for (CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_max() > 0) option->check(not_empty);
  }
}

DrawOptions::~DrawOptions() = default;

DrawArguments DrawOptions::arguments() const {
  const Texts& texts = *texts_;
  DrawArguments arguments;
  arguments.stream = stream_;
  arguments.output = texts.output;
  arguments.html = texts.html;
  arguments.format = texts.format;
  arguments.all_levels = texts.level == "all";
  if (!texts.level.empty() && !arguments.all_levels)
    arguments.stream.last_level = parse_level(texts.level);

  ViewOptions& view = arguments.view;
  if (!texts.views.empty()) view.named = split(texts.views);
  if (!texts.projection.empty())
    view.projection = texts.projection == "third" ? Projection::ThirdAngle : Projection::FirstAngle;
  view.from = parse_vector(texts.from, "--from");
  view.eye = parse_vector(texts.eye, "--eye");
  view.target = parse_vector(texts.target, "--target");
  view.up = parse_vector(texts.up, "--up");
  if (!texts.fov.empty()) view.fov_deg = parse_number(texts.fov, "--fov", "a number of degrees");
  if (texts.stereo == "beside") {
    view.stereo = ViewOptions::Stereo::Beside;
  } else if (texts.stereo == "anaglyph") {
    view.stereo = ViewOptions::Stereo::Anaglyph;
  } else if (!texts.stereo.empty()) {
    throw UsageError("--stereo: '" + texts.stereo + "' should be beside or anaglyph");
  }
  if (!texts.eye_separation.empty()) {
    if (texts.stereo.empty()) throw UsageError("--eye-separation goes with --stereo");
    view.eye_separation =
        parse_number(texts.eye_separation, "--eye-separation", "a fraction of a distance");
  }

  if (!texts.lines.empty()) {
    arguments.with_silhouettes = arguments.with_creases = arguments.with_steps = false;
    for (const std::string& name : split(texts.lines)) {
      bool* const wanted = name == "silhouette" ? &arguments.with_silhouettes
                           : name == "crease"   ? &arguments.with_creases
                           : name == "step"     ? &arguments.with_steps
                                                : nullptr;
      if (wanted == nullptr)
        throw UsageError("--lines: '" + name + "' should be silhouette, crease or step");
      *wanted = true;
    }
  }
  if (!texts.crease_angle.empty())
    arguments.crease_angle_deg =
        parse_number(texts.crease_angle, "--crease-angle", "a number of degrees");
  arguments.with_hidden_lines = texts.hidden == "dashed";
  arguments.colour_by_kind = texts.colour_by == "kind";
  arguments.with_data = !texts.bare;
  if (texts.method == "cells") arguments.method = DrawArguments::Method::Cells;
  arguments.with_statistics = texts.statistics;
  if (!texts.scale.empty()) arguments.page.scale = parse_scale(texts.scale);
  if (!texts.page.empty()) parse_paper(texts.page, arguments.page);
  if (!texts.dpi.empty()) arguments.dpi = parse_number(texts.dpi, "--dpi", "a number");
  return arguments;
}

}  // namespace spoctree
