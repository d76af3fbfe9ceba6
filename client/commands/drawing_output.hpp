// Drawn levels -> files: one per level, one PDF of all, one page of HTML of all.
#pragma once

#include <memory>
#include <string>

#include "client/commands/draw_formats.hpp"
#include "client/commands/level_files.hpp"
#include "client/draw/html_page.hpp"
#include "client/draw/write_pdf.hpp"

namespace spoctree {

/// Of models' names and units.
inline constexpr std::size_t kLongestTitle = 200;

/// What `-o` asks for: a file per level, written at once; or a page per level in one PDF file,
/// written at the end.
class DrawingFiles {
 public:
  /// REQUIRES: `arguments` outlive this. Throws as LevelFiles does.
  explicit DrawingFiles(const DrawArguments& arguments);

  /// Whether levels are kept until the end.
  bool is_document() const { return document_ != nullptr; }
  void add(const LevelPictures& level);
  /// Writes what was kept, if anything was.
  void finish();

 private:
  const DrawArguments& arguments_;
  DrawFormat format_;
  std::unique_ptr<LevelFiles> files_;
  std::unique_ptr<PdfWriter> document_;
  std::string model_;
};

/// What `--html` asks for: a page with every level, written at the end.
class DrawingPage {
 public:
  /// REQUIRES: `arguments` outlive this.
  explicit DrawingPage(const DrawArguments& arguments) : arguments_(arguments) {}

  bool is_wanted() const { return !arguments_.html.empty(); }
  /// REQUIRES: `level` is the stream's last complete one.
  void add(const LevelPictures& level, const LevelStream& stream);
  /// Writes the page, if there is any level.
  void finish();

 private:
  const DrawArguments& arguments_;
  HtmlPage page_;
  HtmlPage::Facts facts_;
};

}  // namespace spoctree
