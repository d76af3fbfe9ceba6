// Point queries on any prefix of a tree.
#pragma once

#include "common/tree/octree.hpp"

namespace spoctree {

/// Where a point lies with respect to the solid, as far as the levels looked at can tell. `Unknown`
/// is the answer in GREY cells of the last level looked at; on a complete tree there are none.
enum class PointClass : std::uint8_t { Out, In, On, Unknown };

/// Classifies a point of universe coordinates (any doubles) against levels 0..`level`. Exact, and a
/// function of the solid alone, however cells and planes divide it. Look at a ball around the point
/// that is small enough: In if it holds material only (but for planes and walls that have material
/// on both sides), Out if it holds none, On if it holds both; Unknown if none of that is certain
/// because part of it is in GREY cells of the last level. Outside the universe cube is Out.
/// O(depth + planes met), no allocation, for points on none of the planes and walls met; some
/// hundred times that for points on one. REQUIRES: a valid tree with at least one level.
PointClass classify_point(const Octree& tree, Vec3 point,
                          std::uint32_t level = static_cast<std::uint32_t>(-1));

}  // namespace spoctree
