// What a camera makes of creases, cubes and pieces.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "client/lines/crease.hpp"
#include "client/lines/crease_parts.hpp"
#include "client/lines/node_extents.hpp"

namespace spoctree {

/// A line of space in the picture, or what of it is far enough in front of the viewer: the points
/// a + t (b - a) with t in `range`. In a perspective, a point half-way along the line is not
/// half-way along it in the picture: parameters are converted.
struct ProjectedLine {
  Vec2 a{0.0};
  Vec2 b{0.0};
  Interval range;      ///< empty if nothing is in front of the viewer
  double depth_a = 1;  ///< at the ends of the range
  double depth_b = 1;

  /// The parameter of a point in the picture, where the range is from 0 to 1.
  double to_picture(double t) const {
    const double u = (t - range.begin) / (range.end - range.begin);
    return u * depth_b / (depth_a + u * (depth_b - depth_a));
  }
  double to_space(double s) const {
    const double u = s * depth_a / (depth_b + s * (depth_a - depth_b));
    return range.begin + u * (range.end - range.begin);
  }
};

ProjectedLine project(Vec3 a, Vec3 b, const Camera& camera);

/// The smallest rectangle around a box; nothing if some of it is not in front of the viewer.
std::optional<Rectangle> extent_of_box(const NodeBox& box, const Camera& camera);

/// Projects the corners of a convex polyhedron. Where some of it is not in front of the viewer, the
/// points are those whose convex hull is the outline of the rest; none if all is.
void project(std::span<const Vec3> corners, const Camera& camera, std::vector<Vec2>& points);

}  // namespace spoctree
