// Whether a polyhedron is what it claims to be, in rational numbers.
#pragma once

#include <set>
#include <string>

#include "common/geometry/polyhedron.hpp"
#include "tests/support/exact.hpp"

namespace spoctree {

/// The first thing that is wrong with a polyhedron's structure, or an empty text. Right is: every
/// vertex is the one point of its three planes, near its position, and not that of another vertex;
/// every corner of a face lies on its plane; faces are strictly convex and counter-clockwise from
/// outside; every edge is shared by exactly two faces that name each other; V - E + F = 2; no
/// vertex is outside any face's plane.
std::string structure_error(const Polyhedron& polyhedron, const PlaneSet& planes);

/// The exact points of its vertices.
std::set<RationalPoint> exact_vertices(const Polyhedron& polyhedron, const PlaneSet& planes);

/// The exact volume, from exact vertices and face loops.
Rational exact_volume(const Polyhedron& polyhedron, const PlaneSet& planes);

/// The vertices of the intersection of half-spaces (which must be bounded) by trying every triple
/// of planes. Knows nothing of polyhedra.
std::set<RationalPoint> enumerated_vertices(const std::vector<Plane>& half_spaces);

/// True if the intersection of half-spaces with these vertices has an interior.
bool has_interior(const std::set<RationalPoint>& vertices, const std::vector<Plane>& half_spaces);

}  // namespace spoctree
