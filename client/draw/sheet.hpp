// Pictures -> one page with all of them at one scale.
#pragma once

#include <span>

#include "client/draw/drawing.hpp"
#include "client/draw/page.hpp"
#include "client/draw/view.hpp"
#include "client/lines/visible_line.hpp"

namespace spoctree {

/// What one view shows.
struct Picture {
  View view;
  VisibleLines lines;
};

struct SheetOptions {
  PageOptions page;
  std::string title;            ///< see Drawing
  bool colour_by_kind = false;  ///< inks of ink_of_kind
  /// Each stroke is one line and knows its source and its planes. Otherwise strokes are runs of
  /// lines that follow each other without lifting the pen.
  bool with_data = true;
};

/// Pictures side by side in reading order, in as many columns as rows or more, each under its
/// picture's name; frames of one column are centred, those of one row too. Lines are cut off at the
/// frames; those of each pen are in a short pen order. Throws UsageError as `lay_out` does.
/// REQUIRES: at least one picture; the first one does not lie over another.
/// O(n log n) in the lines.
Drawing make_sheet(std::span<const Picture> pictures, const Universe& universe,
                   const SheetOptions& options);

}  // namespace spoctree
