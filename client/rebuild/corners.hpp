// Tree -> the corners of its solid's boundary, as planes that meet.
//
// The boundary is known from its corners: on every line in which two planes meet, edges begin and
// end in corners. The corners of any sum of polyhedra are the sum of theirs, and a corner is named
// by its planes, exactly. So every cell says where its material has corners, and almost everything
// cancels: what two cells share, and what a wall cuts off a flat face or an edge.
#pragma once

#include <cstdint>
#include <vector>

#include "client/rebuild/carriers.hpp"
#include "client/rebuild/corner_sum.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// The corners of T_level, each once. What cancels within a cell is summed up there, from small
/// subtrees to the root, in parallel; the order is the same for any number of threads. O(nodes).
std::vector<CornerCount> find_corners(const Octree& tree, std::uint32_t level,
                                      const Carriers& carriers);

/// Per carrier of the tree's planes, on which sides faces of T_level can lie: bit 0 for the side of
/// its own normal, bit 1 for the other one.
std::vector<std::uint8_t> find_sides(const Octree& tree, std::uint32_t level,
                                     const Carriers& carriers);

}  // namespace spoctree
