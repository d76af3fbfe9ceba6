// Planes and points of the grid for tests: at random, and through given points and lines exactly.
#pragma once

#include <vector>

#include "common/geometry/plane.hpp"
#include "tests/support/random.hpp"

namespace spoctree {

/// A unit vector; every direction is as likely as any other.
Vec3 random_direction(Random& random);

/// Coordinates between -`limit` and `limit`.
Vec3 random_vector(Random& random, double limit);

/// The same, multiples of 2^-`point_bits`.
Vec3 random_grid_point(Random& random, int point_bits, double limit = 1);

/// `lowest` .. `highest`.
int random_integer(Random& random, int lowest, int highest);

/// The plane through `point` with `normal` (of any length), rounded to the grid.
Plane grid_plane_through(Vec3 normal, Vec3 point);

/// A plane with a random normal that contains `point`, a multiple of 2^-`point_bits`, exactly.
/// REQUIRES: 0 <= point_bits <= 12.
Plane random_plane_exactly_through(Random& random, Vec3 point, int point_bits);

/// A random plane that contains exactly the line through `point` (as above, with point_bits <= 7)
/// along the non-zero integer vector `direction` (components of at most 3 in magnitude).
Plane random_plane_exactly_through_line(Random& random, Vec3 point, int point_bits,
                                        const int (&direction)[3]);

/// A plane that contains `point` (a multiple of 1/4) exactly, as `plane` must, and whose normal
/// differs from the plane's by some 2^-50 on some axis.
Plane nearly_parallel_plane_through(Random& random, const Plane& plane, Vec3 point);

/// A plane that meets a cell's corners, edges, diagonals and other planes exactly: through one of
/// the 27 points where corners, edge, face and cell centres lie, or a line through one, or in a
/// wall or a middle wall, or one of `older`, either way round; or a random plane through the cell.
/// REQUIRES: centre and half side of the cell are multiples of 2^-7.
Plane random_degenerate_plane(Random& random, Vec3 centre, double half_side,
                              const std::vector<Plane>& older);

}  // namespace spoctree
