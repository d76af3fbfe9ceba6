// The room that things take up in the picture.
#pragma once

#include "client/lines/camera.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// The smallest rectangle around the projected universe cube.
Rectangle extent_of_universe(const Universe& universe, const Camera& camera);

/// The smallest rectangle around the projected T_0. As every T_k lies in T_0, drawings of all
/// levels fit the same frame. The universe's extent if T_0 is empty.
/// REQUIRES: a valid tree with at least one level.
Rectangle extent_of_solid(const Octree& tree, const Camera& camera);

}  // namespace spoctree
