// A drawing -> SVG.
#pragma once

#include <string>
#include <string_view>

#include "client/draw/drawing.hpp"

namespace spoctree {

struct SvgStyle {
  std::string title;
  /// Widths of the pens, in the page's units.
  double crease_width = 0.7;
  double silhouette_width = 1.4;
  double hidden_width = 0.5;
};

/// The drawing as one SVG document: a path per layer, with the layer's name as its class, so that a
/// style sheet can restyle it. Coordinates are rounded to a hundredth of the page's unit; strokes
/// that vanish by that are left out.
std::string to_svg(const Drawing& drawing, const SvgStyle& style = {});

}  // namespace spoctree
