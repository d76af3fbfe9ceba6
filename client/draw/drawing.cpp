#include "client/draw/drawing.hpp"

#include <algorithm>

#include "common/base/errors.hpp"

namespace spoctree {

Drawing make_drawing(const VisibleLines& lines, const Camera& camera, const PageOptions& options) {
  const Vec2 extent = options.frame.upper - options.frame.lower;
  const double room = options.size - 2 * options.margin;
  if (!(extent.x > 0 && extent.y > 0)) throw UsageError("the frame of the drawing is empty");
  if (!(room > 0 && options.margin >= 0)) throw UsageError("the page has no room for a drawing");
  const double scale = room / std::max(extent.x, extent.y);
  const auto on_page = [&](Vec3 point) {
    const Vec2 at = camera.project(point);
    return Vec2{options.margin + (at.x - options.frame.lower.x) * scale,
                options.margin + (options.frame.upper.y - at.y) * scale};
  };
  Drawing drawing;
  drawing.width = extent.x * scale + 2 * options.margin;
  drawing.height = extent.y * scale + 2 * options.margin;
  const VisibleLine* last = nullptr;
  Layer last_layer = Layer::Hidden;
  for (const VisibleLine& line : lines) {
    const Layer layer = line.hidden
                            ? Layer::Hidden
                            : (line.kind == LineKind::Crease ? Layer::Crease : Layer::Silhouette);
    auto& strokes = drawing.layers[static_cast<std::size_t>(layer)];
    const bool goes_on = last != nullptr && last_layer == layer && last->b == line.a;
    if (!goes_on) strokes.push_back({on_page(line.a)});
    strokes.back().push_back(on_page(line.b));
    last = &line;
    last_layer = layer;
  }
  return drawing;
}

}  // namespace spoctree
