// The volume and the surface area of the solid in one cell, from its clipped boundary alone.
#pragma once

#include "server/build/cell.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

/// Volume of the solid's part in a cell, in cubed universe units. The divergence theorem three
/// times over: the flux of (x - x0) e_x through the boundary leaves the cell's boundary triangles
/// and one wall; the area of material on that wall leaves the edges in which triangles meet it and
/// one edge of the cell; the length of material on that leaves the points in which those edges end
/// and one corner of the cell. The cell is seen from a corner whose state is known, looked up in
/// the solid (a hair inside the cell) if there is none. O(corners); error about 1e-15 of the
/// cell's walls' area.
double material_volume(const Solid& solid, const SolidQueries& queries, const Cell& cell);

/// Area of the solid's boundary in a cell, in squared universe units. Boundary in a wall belongs to
/// the cell of its material, so areas of disjoint cells add up. O(corners).
double boundary_area(const Cell& cell);

}  // namespace spoctree
