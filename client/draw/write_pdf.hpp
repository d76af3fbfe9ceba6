// Drawings -> one PDF file, a page each.
//
// Written by hand: cairo, which makes the PNGs, has no layers in its PDFs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/draw/drawing.hpp"
#include "client/draw/pdf_file.hpp"

namespace spoctree {

/// Pages of the drawings' sizes at true scale, an outline entry with each drawing's title, and
/// layers that a viewer can switch: one per pen, and in it one per node kind and level for groups
/// that have a source. Coordinates are rounded to micrometres.
class PdfWriter {
 public:
  /// Throws UsageError if the page is larger than PDF allows (5,080 mm).
  void add_page(const Drawing& drawing);
  int page_count() const { return static_cast<int>(pages_.size()); }
  /// The file. `title` is UTF-8. REQUIRES: at least one page; call once.
  std::string finish(const std::string& title);

 private:
  struct Page {
    int object = 0;
    std::string title;
  };
  struct Layer {
    int object = 0;
    std::string name;
    std::map<std::pair<std::uint8_t, std::string>, int> parts;  ///< objects by level and node
  };
  int layer_of(const Pen& pen);
  int part_of(const Pen& pen, const LineSource& source);
  int add_layer_object(const std::string& name);
  std::string content_of(const Drawing& drawing);
  std::string properties() const;
  std::string layer_order() const;
  int add_outline();

  PdfFile file_;
  int page_tree_ = 0;
  std::vector<Page> pages_;
  std::map<Pen, Layer> layers_;
  std::vector<int> layer_objects_;
};

}  // namespace spoctree
