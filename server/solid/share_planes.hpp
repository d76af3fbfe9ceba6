// Facets that lie in one plane without touching each other share it.
#pragma once

#include <vector>

#include "server/solid/planar_patch.hpp"
#include "server/solid/solid.hpp"

namespace spoctree {

/// A plane of the solid and the heights of the corners of all its facets above it.
struct SharedPlane {
  GridPlane plane;
  HeightRange range;
};

struct SharedPlanes {
  std::vector<SharedPlane> planes;  ///< ordered by their first patch
  std::vector<std::uint32_t> plane_of_patch;
};

/// Larger patches keep their planes, smaller ones take over the plane of a larger one if all
/// corners on it then spread over at most `tolerance` across it, or if the planes are equal.
/// Near-linear unless very many parallel planes are closer than 2^-10.
/// REQUIRES: `solid` has its facet_vertices, one facet for each patch.
SharedPlanes share_planes(const std::vector<PlanarPatch>& patches, const Solid& solid,
                          const std::vector<GridPoint>& points, double tolerance);

}  // namespace spoctree
