// The questions that query benchmarks ask: the same for every program measured.
#pragma once

#include <vector>

#include "common/tree/query_index.hpp"
#include "server/solid/solid.hpp"

namespace spoctree {

/// Points of universe coordinates, on the grid: half of them anywhere in the solid's bounding box,
/// half at 1e-6 to 1e-2 of its diagonal from the surface. The same for the same solid.
std::vector<Vec3> sample_points(const Solid& solid, std::size_t count);

/// Half from a sphere around the solid towards points of its bounding box, half from points of the
/// box in any direction.
std::vector<Ray> sample_rays(const Solid& solid, std::size_t count);

}  // namespace spoctree
