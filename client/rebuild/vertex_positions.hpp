// Vertices of the boundary -> their positions, from the three planes that fix them best.
#pragma once

#include "client/rebuild/chain.hpp"

namespace spoctree {

/// The positions of the welder's vertices; those that the chain uses are moved to the point in
/// which the three most independent planes around them meet, if that is within a few tolerances. Of
/// the points that were welded together, some may stem from nearly parallel planes.
std::vector<Vec3> best_positions(const Chain& chain, const Carriers& carriers,
                                 const VertexWelder& welder);

}  // namespace spoctree
