// A tree of full and void cells -> the same set of points in as few nodes as there can be.
#pragma once

#include <cstdint>
#include <vector>

#include "common/tree/octree.hpp"

namespace spoctree {

/// Replaces every GREY node without planes whose eight children are all BLACK, or all WHITE, by a
/// leaf of that colour, from the deepest level up. Levels that become empty are dropped. Returns,
/// for each level left, the former index of each of its nodes, in order. Planes stay as they are;
/// so do statements, which the caller makes anew. O(nodes). REQUIRES: a complete, valid tree.
std::vector<std::vector<std::uint32_t>> merge_siblings(Octree& tree);

}  // namespace spoctree
