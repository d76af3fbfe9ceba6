// Chain -> faces with outer loops and holes.
#pragma once

#include "client/rebuild/chain.hpp"
#include "client/rebuild/surface.hpp"

namespace spoctree {

/// Traces the boundary edges of every plane into loops, and assigns holes to the outer loops around
/// them. `sides` says on which sides of each carrier faces can lie (find_sides). Fills loops
/// and faces, in the order of the carriers; vertices keep their numbers.
void build_faces(const Chain& chain, const Carriers& carriers, std::span<const std::uint8_t> sides,
                 std::span<const Vec3> positions, Surface& surface);

}  // namespace spoctree
