// How far one convex polyhedron reaches beyond another.
#pragma once

#include <limits>

#include "common/geometry/polyhedron.hpp"

namespace spoctree {

/// No point of `part` that is outside `piece` is farther than this from it: the distance from a
/// convex set is convex, so it is largest in a corner of the part. Universe units; too large by no
/// more than the errors of the vertices and some roundings of coordinates, never too small.
/// O(corners of the one times corners of the other). If the result is not below `enough`, it may be
/// any other number that is not: the rest need not be looked at.
double largest_distance(const Polyhedron& part, const Polyhedron& piece, const PlaneSet& planes,
                        double enough = std::numeric_limits<double>::infinity());

}  // namespace spoctree
