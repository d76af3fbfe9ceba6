// The faces around an edge -> pairs of them with nothing but material, or emptiness, between.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "client/rebuild/surface.hpp"

namespace spoctree {

/// What a solid's boundary is the boundary of.
enum class Filling : std::uint8_t { Material, Emptiness };

/// Pairs the faces around an edge, those of a pair being the two sides of a wedge of the filling;
/// every side is in one pair. Where four or more faces meet, they are sorted by the angle of their
/// planes around the edge (rounding can only mix up faces of less than 1e-15 between them). Appends
/// indices into surface.faces. REQUIRES: as many sides run forward as not. O(n log n) in the sides
/// of the edge.
void pair_sides(const Surface& surface, const Surface::Edge& edge, const PlaneSet& planes,
                Filling filling, std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);

}  // namespace spoctree
