// Polygons into triangles.
#pragma once

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/grid_mesh.hpp"
#include "server/solid/solid.hpp"

namespace spoctree {

/// Fills mesh.triangles: a face of three corners as it is, a larger one, convex or not and with
/// holes that it reaches by bridges, cut along diagonals inside it (its own edges stay whole,
/// bridges need not), counter-clockwise like the face: see split_polygon.hpp. The polygon is seen
/// along the coordinate axis nearest to its mean normal, or along another if it bounds no single
/// area from there; uneven polygons are accepted as long as one works. Fills the report's figures
/// about polygons. n log n in the corners of a face. Throws BadInput for faces whose corners are
/// all on one line (exactly, as the file has them), for faces that cross or touch themselves, for
/// more than kMaxTriangles triangles, and for triangles that vanish on the grid.
void triangulate(const PolygonSoup& soup, GridMesh& mesh, SolidReport& report);

}  // namespace spoctree
