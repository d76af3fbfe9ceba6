// The room that things take up in the picture.
#pragma once

#include "client/lines/camera.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// The smallest rectangle around the projected universe cube. In a perspective from so near that
/// some of it is not in front of the viewer: widest_frame.
Rectangle extent_of_universe(const Universe& universe, const Camera& camera);

/// What a perspective's viewer sees within an angle of 170 degrees. REQUIRES: a perspective.
Rectangle widest_frame(const Camera& camera);

/// The smallest rectangle around the projected T_0. As every T_k lies in T_0, drawings of all
/// levels fit the same frame. The universe's extent if T_0 is empty, or not all in front of the
/// viewer.
/// REQUIRES: a valid tree with at least one level.
Rectangle extent_of_solid(const Octree& tree, const Camera& camera);

}  // namespace spoctree
