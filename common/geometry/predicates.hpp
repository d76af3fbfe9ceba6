// Exact signs on the grid: which side of a plane a point lies on, whether the point is given by
// coordinates, by three planes, or by an edge that crosses a plane.
//
// Every function first evaluates in doubles with a proven error bound, then, if the sign is in
// doubt, in integers (all inputs are integers of at most 54 bits times 2^-52; the widest
// determinant has 216 bits). Plane-based points follow Bernstein and Fussell, Fast, exact, linear
// booleans, SGP 2009.
#pragma once

#include "common/geometry/plane.hpp"

namespace spoctree {

/// normal . point - offset, evaluated in doubles, errs by less than this for coordinates of at most
/// 2 in magnitude: four products and three sums below 8 err by at most 7 * 8 * 2^-53.
inline constexpr double kSideError = 0x1p-47;

/// Sign of normal . point - offset: -1 inside the half-space, 0 on the plane, +1 outside.
/// REQUIRES: the point is on the grid, coordinates at most 2^10 in magnitude (it is not checked).
int side_of_point(const Plane& plane, Vec3 point);

/// The same for any finite doubles, on the grid or not; exact too. Slow (rational numbers) only
/// where a point off the grid lies within 2^-98 of the plane.
int side_of_any_point(const Plane& plane, Vec3 point);

/// Side of the point in which `p`, `q` and `r` meet with respect to `plane`, integers only.
/// REQUIRES: the three normals are linearly independent.
int side_of_intersection(const Plane& p, const Plane& q, const Plane& r, const Plane& plane);

/// Side of the point in which the segment from `a` to `b` (grid points) meets `crossed`, with
/// respect to `plane`, integers only. REQUIRES: a and b lie strictly on different sides of
/// `crossed`, or one of them lies on it.
int side_of_crossing(Vec3 a, Vec3 b, const Plane& crossed, const Plane& plane);

/// The sign of the determinant of four planes, with one row (normal, offset) for each; zero if they
/// meet in a point. Integers only.
int determinant_sign(const Plane& p, const Plane& q, const Plane& r, const Plane& s);

/// Orientation of the three normals: the sign of their determinant.
int orientation_of_normals(const Plane& p, const Plane& q, const Plane& r);

/// A point with a bound on its error: no coordinate is off by more than `error`.
struct ApproximatePoint {
  Vec3 position{0.0};
  double error = 0;
};

/// The point in which three planes meet. The error is at most 2^-45 unless the point has a
/// coordinate beyond 1 in magnitude; ill-conditioned intersections are computed with integers.
/// REQUIRES: the three normals are linearly independent.
ApproximatePoint intersection_point(const Plane& p, const Plane& q, const Plane& r);

/// The point in which the segment from `a` to `b` meets `crossed`; same promise.
ApproximatePoint crossing_point(Vec3 a, Vec3 b, const Plane& crossed);

}  // namespace spoctree
