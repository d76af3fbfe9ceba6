// Cells of a solid for tests of what is decided about one cell: split as the builder's are, but
// axis by axis over the whole grid of a depth.
#pragma once

#include <vector>

#include "server/build/cell.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/hand_solid.hpp"

namespace spoctree {

/// All cells of a depth, by z, y, x. Corner states are unknown.
std::vector<Cell> cells_of(const Solid& solid, const Incidence& incidence, std::uint32_t depth);

/// The exact point that a corner stands for, in rational numbers: from the solid's vertices, the
/// plane of the triangle, and the walls named by the corner's position.
RationalPoint exact_point(const FragmentCorner& corner, std::uint32_t triangle, const Solid& solid);

/// A solid whose vertices have no simple coordinates: a height field with every coordinate moved.
Solid uneven_solid(int cells, Random& random);

double area_of(std::span<const FragmentCorner> polygon);

/// Whether the cell's part of the solid reaches a corner, by an exact inside test: it is asked a
/// step of 2^-22 of the cell away from the corner, into the cell.
Vec3 just_inside(const Solid& solid, const Cell& cell, unsigned octant);

}  // namespace spoctree
