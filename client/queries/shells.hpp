// A rebuilt surface -> its shells: the pieces of boundary that hang together.
#pragma once

#include <vector>

#include "client/queries/pair_sides.hpp"
#include "client/rebuild/surface.hpp"

namespace spoctree {

/// A closed piece of the boundary.
struct Shell {
  /// What it encloses, in universe units; negative if the material is outside: a cavity.
  double volume = 0;
  double area = 0;
  std::uint32_t face_count = 0;
};

/// The shells in the order of their first faces. Where more than two faces meet in an edge, those
/// hang together that have the filling between them. So with Material there is one shell of
/// positive volume for every connected piece of the solid's interior, with Emptiness one of
/// negative volume for every connected piece of enclosed space: what touches in an edge or a vertex
/// only is not connected. `planes` are those of the surface's tree. O(surface), and O(n log n) at
/// an edge of n > 2 faces.
std::vector<Shell> find_shells(const Surface& surface, const PlaneSet& planes, Filling filling);

}  // namespace spoctree
