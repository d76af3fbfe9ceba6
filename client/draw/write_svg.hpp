// A drawing -> SVG.
#pragma once

#include <string>
#include <string_view>

#include "client/draw/drawing.hpp"

namespace spoctree {

struct SvgOptions {
  /// The svg element has the page's size in millimetres, a sheet of white paper and a style sheet.
  /// Otherwise it is a part of an HTML page, which has these (svg_style).
  bool is_document = true;
};

/// The drawing as one svg element, in millimetres of the page rounded to hundredths; strokes that
/// vanish by that are left out. Pens are classes ("crease", "silhouette", "caption"; "step",
/// "hidden"; ink names), so that a style sheet can restyle them. Groups with a source are g
/// elements with data-node and data-level; their paths, one per line, have data-planes, a pair for
/// each stretch as in "7 12, 7 x=2.5": see `name_of`.
std::string to_svg(const Drawing& drawing, const SvgOptions& options = {});

/// The rules for all classes that pens can have.
std::string svg_style();

/// For the text of XML and HTML, attributes included. Control characters become blanks.
std::string escape_xml(std::string_view text);

}  // namespace spoctree
