// Where a node of a tree is.
#pragma once

#include "common/tree/octree.hpp"

namespace spoctree {

/// A node of a tree and its cube. `lower` are wall indices (units of the finest cells).
struct NodeAddress {
  std::uint32_t level = 0;
  std::uint32_t index = 0;  ///< within the level
  std::uint32_t lower[3] = {0, 0, 0};

  /// Side of the cube in units of the finest cells.
  std::uint32_t size() const { return std::uint32_t{1} << (kMaxDepth - static_cast<int>(level)); }
  /// The address of a child, given the parent's `first_child`.
  NodeAddress child(std::uint32_t first_child, std::uint32_t octant) const {
    NodeAddress address{level + 1, first_child + octant, {lower[0], lower[1], lower[2]}};
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      if ((octant >> axis) & 1) address.lower[axis] += address.size();
    }
    return address;
  }
};

/// A node with everything below it, as a part of a walk that does not depend on the others.
struct Subtree {
  NodeAddress root;
  /// The ancestors' planes that may cut the root's cube.
  std::vector<std::uint32_t> planes;
};

}  // namespace spoctree
