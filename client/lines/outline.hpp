// A convex piece seen from the viewer: one convex polygon.
#pragma once

#include <vector>

#include "client/lines/camera.hpp"

namespace spoctree {

/// The convex hull of at least three points, counter-clockwise, strictly convex up to the rounding
/// of a cross product; nothing if they are on one line. Sorts the points. O(n log n). Source:
/// A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, Information
/// Processing Letters 9 (5), 1979.
void find_outline(std::vector<Vec2>& points, std::vector<Vec2>& outline);

}  // namespace spoctree
