// A tree of full and void cells -> the volume and the surface of every level.
#pragma once

#include "common/tree/octree.hpp"

namespace spoctree {

/// Fills the volumes and areas of all statements from the tree alone; error bounds stay. Inner is
/// what the BLACK leaves of levels 0..k have: their volume, and those parts of the last level's
/// boundary that lie on them. Outer volume is that of T_k, outer area the last level's. Exact but
/// for the rounding of sums of powers of two times a power of the cube's side. O(nodes).
/// REQUIRES: a complete, valid tree of WHITE, BLACK and GREY nodes without planes.
void measure_cubes(Octree& tree);

/// The BLACK leaves that have a part of the boundary: all but those with full neighbours on all six
/// sides (the "graphics nodes" of Veenstra and Ahuja, ACM TOG 1988). O(nodes). REQUIRES: as above.
std::uint64_t count_exposed_cubes(const Octree& tree);

}  // namespace spoctree
