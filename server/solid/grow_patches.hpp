// Region growing: triangles into connected patches that are flat within a tolerance.
#pragma once

#include <vector>

#include "server/solid/planar_patch.hpp"
#include "server/solid/solid.hpp"

namespace spoctree {

struct GrownPatches {
  std::vector<PlanarPatch> patches;
  std::size_t distinct_triangle_planes = 0;  ///< rounded to the grid
};

/// Gives every triangle its `facet`, an index in the patches returned; these are ordered by their
/// first triangle. The corners of a patch spread over at most `tolerance` (universe units) across
/// its plane, or, with tolerance 0, its triangles' planes are equal. O(n log n).
/// REQUIRES: as group_into_facets.
GrownPatches grow_patches(std::vector<SolidTriangle>& triangles,
                          const std::vector<GridPoint>& points, double tolerance);

}  // namespace spoctree
