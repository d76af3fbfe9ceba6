// Which side of a plane the faces beside its boundary edges look to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/rebuild/loop_tracer.hpp"

namespace spoctree {

/// A boundary edge of a plane's faces, `count` > 0 times. To its left the plane's value is larger
/// by `count` than to its right; the value is +1 on faces that look along the normal, -1 on faces
/// that look the other way, 0 elsewhere.
struct CountedEdge {
  PlaneEdge edge;
  std::int32_t count = 0;
};

/// Finds the values from the edges alone, and with them the boundary of the faces that look along
/// the normal (`front`) and of the others (`back`, reversed, so that faces lie to the left seen
/// from their outside). Both together use every edge as often as it counts. The edges must not
/// cross. If the values are contradictory (rounding) all becomes `front`.
/// O(n log n + connected parts * edges at the same height).
void separate_sides(std::span<const CountedEdge> edges, const PlaneFrame& frame,
                    std::span<const Vec3> positions, std::vector<PlaneEdge>& front,
                    std::vector<PlaneEdge>& back);

}  // namespace spoctree
