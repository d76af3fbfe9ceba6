// Triangles with planes into facets: what is connected in one plane is one face of the solid.
#pragma once

#include <span>

#include "server/solid/grid_plane.hpp"
#include "server/solid/solid.hpp"

namespace spoctree {

/// Fills the solid's facets and planes and largest_incidence_gap. Neighbours whose planes are equal
/// join; facets with equal planes share it. A plane is moved outwards, by a few steps of the grid
/// at most, until it has all corners of its facets inside. Facets are numbered by their first
/// triangle, planes by their first facet. n log n.
/// REQUIRES: vertices on the grid, triangles with corners and neighbours; universe; `planes` has
/// the plane of each triangle, which passes within a few steps of the grid of its corners.
void group_into_facets(Solid& solid, std::span<const GridPlane> planes);

/// The same, each triangle with its own plane. REQUIRES: none is degenerate.
void group_into_facets(Solid& solid);

}  // namespace spoctree
