// One view, drawn by both methods -> where they differ.
#pragma once

#include "client/cells/cell_scene.hpp"
#include "tests/support/compare_drawings.hpp"

namespace spoctree {

/// First front to back, second along avenues of sight; at 1e-6 of the universe's diagonal.
DrawingDifference compare_methods(const LineScene& scene, const CellScene& cells,
                                  const Camera& camera, const Rectangle& frame);

}  // namespace spoctree
