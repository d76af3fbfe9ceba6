// Point queries on any prefix of a tree.
#pragma once

#include "common/tree/octree.hpp"

namespace spoctree {

/// Where a point lies with respect to the solid, as far as the levels looked at can tell. `Unknown`
/// is the answer in GREY cells of the last level looked at; on a complete tree there are none.
enum class PointClass : std::uint8_t { Out, In, On, Unknown };

/// Classifies a point of universe coordinates (any doubles) against levels 0..`level`. Signs are
/// exact; `On` means exactly on a boundary plane or, undecided by one cell, on a cell wall.
/// O(depth + planes met), no allocation.
PointClass classify_point(const Octree& tree, Vec3 point,
                          std::uint32_t level = static_cast<std::uint32_t>(-1));

}  // namespace spoctree
