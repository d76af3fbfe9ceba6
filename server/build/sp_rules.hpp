// What can be chosen about an SP-Octree.
#pragma once

#include <cstdint>

#include "common/tree/octree.hpp"

namespace spoctree {

struct SpRules {
  /// A cell with at most this many remaining planes becomes a VERTEX leaf even if they share no
  /// vertex. 0: the paper's rule alone.
  std::uint32_t leaf_planes = 0;
  /// A cell at this depth becomes a VERTEX leaf whatever it holds.
  std::uint32_t max_depth = kMaxDepth;
};

}  // namespace spoctree
