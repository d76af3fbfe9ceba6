// Plane coordinates of the points of a carrier, by leaving out one coordinate.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>

#include "common/geometry/plane.hpp"

namespace spoctree {

using Vec2 = glm::dvec2;

/// Projects along the axis nearest to a plane's normal, so that what is counter-clockwise seen
/// against the normal is counter-clockwise in (x, y). Lengths shrink by at most sqrt(3).
class PlaneFrame {
 public:
  PlaneFrame(const Plane& plane, bool is_flipped) {
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
      if (std::abs(plane.normal[i]) > std::abs(plane.normal[axis])) axis = i;
    }
    x_ = (axis + 1) % 3;
    y_ = (axis + 2) % 3;
    if ((plane.normal[axis] < 0) != is_flipped) std::swap(x_, y_);
  }
  Vec2 project(Vec3 point) const { return {point[x_], point[y_]}; }

 private:
  int x_, y_;
};

inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace spoctree
