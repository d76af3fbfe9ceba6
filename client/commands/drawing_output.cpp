#include "client/commands/drawing_output.hpp"

#include "common/program/output.hpp"
#include "common/report/level_rows.hpp"
#include "common/wire/text.hpp"

namespace spoctree {

DrawingFiles::DrawingFiles(const DrawArguments& arguments)
    : arguments_(arguments), format_(choose_format(arguments)) {
  if (arguments.output.empty()) return;
  const bool is_one_document = arguments.all_levels && format_ == DrawFormat::Pdf &&
                               LevelFiles::is_one_file(arguments.output);
  files_ = std::make_unique<LevelFiles>(arguments.output, arguments.all_levels && !is_one_document,
                                        extension_of(format_));
  if (is_one_document) document_ = std::make_unique<PdfWriter>();
}

void DrawingFiles::add(const LevelPictures& level) {
  if (!files_) return;
  if (document_) {
    document_->add_page(sheet_of(level, arguments_, format_));
    model_ = level.model;
  } else {
    write_output(files_->name_of(level.level), encode(level, arguments_, format_));
  }
}

void DrawingFiles::finish() {
  if (document_ && document_->page_count() > 0)
    write_output(files_->name_of(0), document_->finish(model_));
}

void DrawingPage::add(const LevelPictures& level, const LevelStream& stream) {
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

void DrawingPage::finish() {
  if (page_.level_count() > 0) write_output(arguments_.html, page_.finish(facts_));
}

}  // namespace spoctree
