// Region growing: triangles into connected patches that are flat within a tolerance.
#pragma once

#include <vector>

#include "server/solid/flat_surface.hpp"
#include "server/solid/planar_patch.hpp"

namespace spoctree {

/// The patches of at least two triangles, from that with the largest triangle on. No triangle is in
/// two; each is in one if a neighbour fits. Starting from the largest triangles, neighbours join
/// while the corners of all stay between two parallel planes `tolerance` (universe units) apart.
/// O(n log n). REQUIRES: 0 < tolerance < 1.
std::vector<PlanarPatch> grow_patches(const FlatSurface& surface, double tolerance);

}  // namespace spoctree
