// Triangles into facets: what lies in one plane becomes one face of the solid.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "server/solid/solid.hpp"

namespace spoctree {

/// Fills the solid's facets and planes, largest_incidence_gap and the report's figures about
/// planes. Starting from the largest triangles, neighbours join while the corners of all stay
/// between two parallel planes `tolerance` (universe units) apart; then facets with the same
/// orientation share a plane if all their corners do so. A plane is moved outwards until it has all
/// corners of its facets inside, so none is farther than `tolerance` from it, up to the rounding to
/// the grid. With tolerance 0 only triangles whose planes, rounded to the grid, are equal join.
/// Facets are numbered by their first triangle, planes by their first facet. O(n log n).
/// REQUIRES: vertices on the grid, triangles with corners and neighbours, none degenerate;
/// universe; 0 <= tolerance < 1.
void group_into_facets(Solid& solid, double tolerance);

/// How far from an edge its two planes may meet instead, in universe units.
inline constexpr double kMostEdgeShift = 0x1p-10;

/// The first edge, as two vertices, that is lost because planes were moved outwards: its two facets
/// face away from each other by nearly 180 degrees, and their planes meet farther from it than
/// kMostEdgeShift. It happens where a part is about as thin as the tolerance. Linear.
std::optional<std::array<std::uint32_t, 2>> find_lost_edge(const Solid& solid);

}  // namespace spoctree
