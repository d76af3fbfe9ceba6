// Which corners of a cell the solid's material reaches, from one corner and the cell's edges.
#pragma once

#include "server/build/cell.hpp"

namespace spoctree {

/// Fills the Unknown entries of `cell.corners` that follow from the known ones: the state changes
/// along an edge of the cell wherever a face crosses it. An edge that the boundary meets in any
/// other way than by the inside of a face tells nothing; what depends on it stays Unknown.
/// O(corners of the cell's boundary).
void propagate_corner_states(const Solid& solid, Cell& cell);

}  // namespace spoctree
