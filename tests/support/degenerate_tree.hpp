// Valid octrees full of coincidences: for tests of what must be exact.
#pragma once

#include "common/tree/octree.hpp"
#include "tests/support/random.hpp"

namespace spoctree {

/// A complete tree of at most `levels` (<= 6) levels, whose planes go through corners, edges and
/// centres of cells, through common points and lines, lie in walls, or on each other under other
/// numbers (random_degenerate_plane). The half side is 1. Nodes may speak of empty regions.
Octree degenerate_tree(std::uint64_t seed, std::uint32_t levels);

}  // namespace spoctree
