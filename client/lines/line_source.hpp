// A place on a crease -> where the tree has it from.
#pragma once

#include <span>

#include "client/lines/visible_line.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// The source of a line at `point`, whose faces lie in `planes` (outward normals): the leaf of
/// T_level, or its GREY node, that has the material beside the point. Which one is decided up to
/// rounding. O(depth).
LineSource find_source(const Octree& tree, std::uint32_t level, Vec3 point,
                       std::span<const PlaneRef> planes);

}  // namespace spoctree
