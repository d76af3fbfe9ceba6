// The distance of a point from a triangle, accurate for triangles of any shape.
#pragma once

#include "common/geometry/universe.hpp"

namespace spoctree {

/// A triangle ready to be measured from. REQUIRES: corners on the grid, not on one line.
class MeasuredTriangle {
 public:
  MeasuredTriangle(Vec3 a, Vec3 b, Vec3 c);

  /// The error of its square root is below 2^-46 for points of the universe cube: a point that is
  /// over the triangle for certain is measured along the normal, which comes from an exact cross
  /// product (for slivers, too), any other along the way to the nearest edge.
  double squared_distance(Vec3 p) const;

 private:
  Vec3 corners_[3];
  Vec3 normal_;
};

}  // namespace spoctree
