// A polygon with holes -> simple polygons, by bridges between its vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/rebuild/loop_tracer.hpp"

namespace spoctree {

/// Cuts the region between an outer loop (counter-clockwise in `frame`) and its holes (clockwise)
/// along two bridges per hole: from its leftmost vertex to one further left, from its rightmost
/// vertex to one further right. Either way leads on to the outer loop, so that no part is enclosed
/// by another. The parts use every edge of the loops once and every bridge once each way. "Left" is
/// along an oblique direction, because holes often stand in line. O(holes * vertices).
void bridge_holes(std::span<const std::span<const std::uint32_t>> loops, const PlaneFrame& frame,
                  std::span<const Vec3> positions, TracedLoops& result);

}  // namespace spoctree
