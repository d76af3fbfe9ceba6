// Triangles that share points into triangles that know their neighbours, or the reason why they do
// not bound anything.
#pragma once

#include "server/solid/grid_mesh.hpp"

namespace spoctree {

/// For each triangle the triangle across edge i (from corner i to corner i + 1). Linear, but for
/// sorting the edges around each vertex.
/// Throws BadInput for edges with more than two triangles, edges with one, and edges that both
/// triangles run along in the same direction; if there are none of these, for vertices whose
/// triangles form more than one fan. The text counts them and names the first in the order of the
/// file. If the solid `may_touch_itself`, edges along which wedges of material touch and vertices
/// with several fans are not refused: neighbours bound the same wedge.
std::vector<Corners> find_neighbours(const GridMesh& mesh, bool may_touch_itself = false);

}  // namespace spoctree
