// Tree and creases -> the parts of the creases that are seen: the walk from front to back.
#pragma once

#include <vector>

#include "client/lines/camera.hpp"
#include "client/lines/crease.hpp"
#include "client/lines/crease_pool.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// The parts of `open` that no piece of T_level hides. Each part is tested, in the plane of the
/// picture, against the union of the outlines of the pieces visited before the first piece that
/// touches it. In the order found; parts of one crease may touch and overlap. Of creases that lie
/// one behind the other in the picture, on the outline of material, only the nearer may be found.
/// Parts come from `open` with the sides of open_sides. REQUIRES: a valid tree; creases of the
/// boundary of T_level.
std::vector<CreasePart> find_seen_parts(const Octree& tree, std::uint32_t level,
                                        const Creases& creases, std::vector<CreasePart> open,
                                        const Camera& camera);

}  // namespace spoctree
