// Patches that lie in one plane without touching each other share it.
#pragma once

#include <vector>

#include "server/solid/flat_surface.hpp"
#include "server/solid/planar_patch.hpp"

namespace spoctree {

/// The number of each patch's plane. Larger patches keep their planes, smaller ones take over that
/// of a larger one if all corners on it then spread over at most `tolerance` across it, or if the
/// planes are equal. Near-linear unless very many parallel planes are closer than 2^-10.
std::vector<std::uint32_t> share_planes(const std::vector<PlanarPatch>& patches,
                                        const FlatSurface& surface, double tolerance);

}  // namespace spoctree
