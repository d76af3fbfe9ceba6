#include <cstdio>
#include <memory>
#include <optional>

#include "client/commands/commands.hpp"
#include "client/commands/draw_formats.hpp"
#include "client/commands/level_files.hpp"
#include "client/draw/html_page.hpp"
#include "client/draw/write_pdf.hpp"
#include "client/lines/visible_lines.hpp"
#include "client/rebuild/surface.hpp"
#include "common/base/errors.hpp"
#include "common/base/interruption.hpp"
#include "common/program/output.hpp"
#include "common/report/level_rows.hpp"
#include "common/wire/text.hpp"

namespace spoctree {

namespace {

constexpr std::size_t kLongestTitle = 200;

bool is_wanted(const VisibleLine& line, const DrawArguments& arguments) {
  if (line.is_step && !arguments.with_steps) return false;
  if (line.is_step && arguments.with_steps) return true;
  return line.kind == LineKind::Crease ? arguments.with_creases : arguments.with_silhouettes;
}

/// Levels -> files, as each is drawn; or a page per level in one file, at the end.
class DrawingFiles {
 public:
  explicit DrawingFiles(const DrawArguments& arguments)
      : arguments_(arguments), format_(choose_format(arguments)) {
    if (arguments.output.empty()) return;
    const bool is_document = arguments.all_levels && format_ == DrawFormat::Pdf &&
                             LevelFiles::is_one_file(arguments.output);
    files_ = std::make_unique<LevelFiles>(arguments.output, arguments.all_levels && !is_document,
                                          extension_of(format_));
    if (is_document) document_ = std::make_unique<PdfWriter>();
  }

  bool is_document() const { return document_ != nullptr; }
  void add(const LevelPictures& level) {
    if (!files_) return;
    if (document_) {
      document_->add_page(sheet_of(level, arguments_, format_));
      model_ = level.model;
    } else {
      write_output(files_->name_of(level.level), encode(level, arguments_, format_));
    }
  }
  void finish() {
    if (document_ && document_->page_count() > 0)
      write_output(files_->name_of(0), document_->finish(model_));
  }

 private:
  const DrawArguments& arguments_;
  DrawFormat format_;
  std::unique_ptr<LevelFiles> files_;
  std::unique_ptr<PdfWriter> document_;
  std::string model_;
};

LevelPictures draw_level(const LevelStream& stream, const DrawArguments& arguments) {
  const Octree& tree = stream.tree();
  LevelPictures level;
  level.model = clean_text(stream.model_name(), kLongestTitle);
  level.level = stream.level();
  level.universe = tree.universe;
  LineOptions options;
  options.crease_angle_deg = arguments.crease_angle_deg;
  options.with_hidden_lines = arguments.with_hidden_lines;
  const LineScene scene(tree, rebuild_surface(tree, level.level), level.level);
  for (View& view : make_views(arguments.view, tree)) {
    VisibleLines lines = visible_lines(scene, view.camera, options);
    std::erase_if(lines, [&](const VisibleLine& line) { return !is_wanted(line, arguments); });
    level.pictures.push_back({std::move(view), std::move(lines)});
  }
  return level;
}

/// Every level -> one page of HTML, at the end.
class DrawingPage {
 public:
  explicit DrawingPage(const DrawArguments& arguments) : arguments_(arguments) {}

  bool is_wanted() const { return !arguments_.html.empty(); }
  void add(const LevelPictures& level, const LevelStream& stream) {
    DrawArguments bare = arguments_;
    bare.with_data = false;
    page_.add_level(sheet_of(level, bare, DrawFormat::Svg),
                    level_rows(stream.tree(), stream.decoder().level_bytes()).back());
    const StreamInfo& info = stream.decoder().info();
    facts_.model = level.model;
    facts_.units = clean_text(info.source.units, kLongestTitle);
    facts_.level_count =
        arguments_.stream.last_level ? *arguments_.stream.last_level + 1 : info.level_count;
  }
  void finish() {
    if (page_.level_count() > 0) write_output(arguments_.html, page_.finish(facts_));
  }

 private:
  const DrawArguments& arguments_;
  HtmlPage page_;
  HtmlPage::Facts facts_;
};

void draw_levels(const DrawArguments& arguments, DrawingFiles& files, DrawingPage& page) {
  LevelStream stream(arguments.stream);
  const auto draw = [&] {
    stream.progress_line().show("drawing level " + std::to_string(stream.level()));
    return draw_level(stream, arguments);
  };
  LevelPictures last;
  // While a level is drawn, the next one waits in the socket.
  while (stream.next_level()) {
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
