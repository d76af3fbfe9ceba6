// A convex piece seen from the viewer: one convex polygon.
#pragma once

#include <vector>

#include "client/lines/camera.hpp"

namespace spoctree {

/// Leaves out corners of a convex polygon that are nearer than `tolerance` to the one before, and
/// those next to a short edge that stand off the straight line past them by less than a fraction of
/// it: between such corners, rounding decides where the edge points, and an edge that points astray
/// cuts off what is far away. Nothing is left of a polygon without area.
void straighten(std::vector<Vec2>& polygon, double tolerance);

/// The convex hull of at least three points, counter-clockwise, straightened. Sorts the points.
/// O(n log n). Source: A. M. Andrew, Another efficient algorithm for convex hulls in two
/// dimensions, Information Processing Letters 9 (5), 1979.
void find_outline(std::vector<Vec2>& points, double tolerance, std::vector<Vec2>& outline);

}  // namespace spoctree
