// What can be chosen about a classical octree.
#pragma once

#include <cstdint>

namespace spoctree {

/// What becomes of the cells that are mixed at the depth limit.
enum class PartialCells : std::uint8_t {
  Full,  ///< BLACK: the tree contains the solid
  Void,  ///< WHITE: the solid contains the tree
  Half   ///< as the cell's centre is; a centre exactly on the boundary counts as inside
};

struct ClassicalRules {
  std::uint32_t max_depth = 0;
  PartialCells partial = PartialCells::Full;
};

}  // namespace spoctree
