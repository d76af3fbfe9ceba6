// Convex cells -> fewer of them: neighbours are made one where that is convex, too.
#pragma once

#include <cstdint>
#include <vector>

#include "common/base/progress_meter.hpp"
#include "common/geometry/polyhedron.hpp"

namespace spoctree {

struct MergedCells {
  std::vector<Polyhedron> cells;
  std::vector<std::uint32_t> cell_of;  ///< by the number of a cell before merging
};

/// Makes one cell of two that share a whole face, if their union is convex: if, exactly, no corner
/// of either is outside a plane of the other, but for the shared face's. Largest shared faces
/// first, until nothing can be merged; same cells, same result. Neighbours that lie in planes of
/// different names are left alone, even if these planes are equal. About O(corners log corners)
/// for cells of few faces. REQUIRES: disjoint cells, each face of them with one plane of its own.
/// Throws what `progress` throws.
MergedCells merge_cells(std::vector<Polyhedron> cells, const PlaneSet& planes,
                        const ProgressShare& progress = {});

}  // namespace spoctree
