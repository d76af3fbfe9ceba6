// A tree -> where its coarsest solid reaches.
#pragma once

#include <vector>

#include "common/tree/octree.hpp"

namespace spoctree {

/// The corners of T_0's pieces, in universe coordinates, in a fixed order. As every T_k lies in the
/// convex hull of these, they frame all levels. The universe's corners if T_0 is empty.
/// REQUIRES: a valid tree with at least one level.
std::vector<Vec3> coarsest_points(const Octree& tree);

/// The middle of the points' bounding box. REQUIRES: not empty.
Vec3 middle_of(const std::vector<Vec3>& points);

}  // namespace spoctree
