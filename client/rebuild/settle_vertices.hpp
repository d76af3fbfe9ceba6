// Vertices of the boundary -> points in which the planes around them meet.
#pragma once

#include "client/rebuild/chain.hpp"

namespace spoctree {

/// Makes one vertex of the two ends of a short edge if all planes around them meet in one point, up
/// to their rounding: in a vertex of the solid with more than three planes, two of them nearly
/// parallel, the rounded planes meet in a cluster wider than the welder's tolerance. Moves every
/// vertex in use to the point in which the three most independent planes around it meet. The chain
/// is normalized before and after. Returns true if vertices became one. O(n log n).
bool settle_vertices(Chain& chain, const Carriers& carriers, VertexWelder& welder);

}  // namespace spoctree
