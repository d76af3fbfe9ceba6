// Half of the picture's plane.
#pragma once

#include <glm/geometric.hpp>

#include "client/lines/camera.hpp"

namespace spoctree {

/// { p : normal . p <= offset }.
struct HalfPlane {
  Vec2 normal{0.0};
  double offset = 0;

  /// How far beyond it a point is, for a unit normal.
  double operator()(Vec2 p) const { return glm::dot(normal, p) - offset; }
};

}  // namespace spoctree
