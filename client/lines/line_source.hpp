// Lines -> where the tree has it from, stretch by stretch.
#pragma once

#include "client/lines/visible_line.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// Divides the stretches of the lines where the leaves of T_level (or its GREY nodes) end that have
/// the material beside it, and says of which each is. Which side of a wall the material is on, and
/// with that where the stretches end, is decided up to rounding; those shorter than kShortestLine
/// go to the ones before them. O(depth) for each leaf along a line.
void find_sources(VisibleLines& lines, const Octree& tree, std::uint32_t level);

}  // namespace spoctree
