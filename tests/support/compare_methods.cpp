#include "tests/support/compare_methods.hpp"

#include "client/lines/visible_lines.hpp"

namespace spoctree {

DrawingDifference compare_methods(const LineScene& scene, const CellScene& cells,
                                  const Camera& camera, const Rectangle& frame) {
  LineOptions options;
  options.frame = frame;
  const VisibleLines front = visible_lines(scene, camera, options);
  options.find_seen_parts = cells.finder();
  const VisibleLines seen = visible_lines(scene, camera, options);
  return compare_drawings(front, seen, camera, frame, 1e-6 * scene.diagonal());
}

}  // namespace spoctree
