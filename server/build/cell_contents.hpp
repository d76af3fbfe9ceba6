// What a cell's boundary says about it, whatever the kind of tree.
#pragma once

#include <span>

#include "server/build/cell.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

/// Whether a cell that the solid's boundary does not divide is material. Faces that the cell has
/// nonetheless (in its walls, or taken by an ancestor) have their material in it. Without faces any
/// corner tells that is known; where none is, the solid is asked about the centre. O(1) and at most
/// one query.
bool is_all_material(const Solid& solid, const SolidQueries& queries, const Cell& cell);

/// The triangle of that one of `fragments`, which are the cell's and at least one, whose middle is
/// nearest to the cell's centre. O(corners).
std::uint32_t triangle_near_centre(const Solid& solid, const Cell& cell,
                                   std::span<const Fragment> fragments);

}  // namespace spoctree
