// Polygons into triangles.
#pragma once

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/grid_mesh.hpp"
#include "server/solid/solid.hpp"

namespace spoctree {

/// Fills mesh.triangles: a face of three corners as it is, a larger one, convex or not, cut along
/// diagonals inside it (its own edges stay whole), counter-clockwise like the face. The polygon is
/// seen along the coordinate axis nearest to its mean normal, or along another if it is not simple
/// from there; uneven polygons are accepted as long as one works. Fills the report's figures about
/// polygons. n log n in the corners of a face.
/// Throws BadInput for faces whose corners are all on one line (exactly, as the file has them), for
/// faces that cross or touch themselves, for more than kMaxTriangles triangles, and for triangles
/// that vanish on the grid.
void triangulate(const PolygonSoup& soup, GridMesh& mesh, SolidReport& report);

}  // namespace spoctree
