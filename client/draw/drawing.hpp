// Lines of space -> strokes on a page.
#pragma once

#include <array>
#include <vector>

#include "client/lines/camera.hpp"
#include "client/lines/visible_line.hpp"

namespace spoctree {

/// What a stroke is drawn with, in drawing order.
enum class Layer : std::uint8_t { Hidden, Crease, Silhouette };
inline constexpr int kLayerCount = 3;

/// The pen goes down at the first point and up at the last.
using Stroke = std::vector<Vec2>;

/// A page: the origin is the upper left corner, y goes downwards.
struct Drawing {
  double width = 0;
  double height = 0;
  std::array<std::vector<Stroke>, kLayerCount> layers;

  const std::vector<Stroke>& strokes(Layer layer) const {
    return layers[static_cast<std::size_t>(layer)];
  }
};

struct PageOptions {
  /// The part of the picture that is shown. extent_of_solid gives all levels of a tree the same page,
  /// so that their drawings can be laid side by side.
  Rectangle frame;
  /// The longer side of the page, margins included; in the page's units.
  double size = 1000;
  double margin = 20;
};

/// Puts lines on a page. Each stroke is a run of lines that follow each other without lifting the
/// pen; the order of the lines is kept. Throws UsageError if the frame is empty or the page has no
/// room between its margins.
Drawing make_drawing(const VisibleLines& lines, const Camera& camera, const PageOptions& options);

}  // namespace spoctree
