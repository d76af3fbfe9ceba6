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
  VisibleLines lines;  ///< within the view's frame
};

/// Cuts the lines off at the view's frame.
Picture make_picture(View view, const VisibleLines& lines);

/// What strokes know of the tree. The less, the longer they are.
enum class LineData : std::uint8_t {
  None,    ///< strokes are runs of lines of one pen
  Source,  ///< and of one source
  Planes   ///< each straight line of the picture is a stroke
};

struct SheetOptions {
  PageOptions page;
  std::string title;            ///< see Drawing
  bool colour_by_kind = false;  ///< inks of ink_of_kind
  LineData data = LineData::Planes;
  /// Its symbol goes into the lower right corner of the page.
  std::optional<Projection> symbol;
};

/// Pictures in the cells of their views, or else side by side in reading order, in as many columns
/// as rows or more, each above its name; frames of one column are centred, those of one row too, so
/// that views from the sides of a solid have common axes. Lines of each pen are in a short pen
/// order; those that go straight on in the picture become one, of the longest one's source.
/// Throws UsageError as `lay_out` does.
/// REQUIRES: at least one picture; the first one does not lie over another; all of those that do
/// not have cells, each its own, or none has.
/// O(n log n) in the lines.
Drawing make_sheet(std::span<const Picture> pictures, const Universe& universe,
                   const SheetOptions& options);

}  // namespace spoctree
