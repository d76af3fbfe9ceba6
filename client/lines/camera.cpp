#include "client/lines/camera.hpp"

#include <algorithm>
#include <cmath>

#include "common/base/errors.hpp"
#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

/// Scaled first, so that the squares neither overflow nor vanish.
Vec3 unit_vector(Vec3 v, const char* name) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
    throw UsageError(std::string(name) + " must be finite and not zero");
  }
  return glm::normalize(v / largest);
}

/// Directions along an axis up to rounding are along it.
Vec3 snapped(Vec3 direction) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < kEdgeOnTolerance) direction[axis] = 0;
  }
  return glm::normalize(direction);
}

}  // namespace

Camera::Camera(Vec3 toward_viewer, Vec3 up) {
  turn(unit_vector(toward_viewer, "the direction of view"), up);
}

Camera Camera::perspective(Vec3 eye, Vec3 target, Vec3 up) {
  Camera camera;
  camera.turn(unit_vector(eye - target, "the way from the target to the eye"), up);
  camera.eye_ = eye;
  camera.focal_length_ = glm::distance(eye, target);
  camera.least_depth_ = kLeastDepth;
  return camera;
}

void Camera::turn(Vec3 toward_viewer, Vec3 up) {
  toward_viewer_ = snapped(toward_viewer);
  up = unit_vector(up, "the direction upwards");
  Vec3 right = glm::cross(up, toward_viewer_);
  for (const Vec3 other : {Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    if (glm::length(right) < kEdgeOnTolerance) right = glm::cross(other, toward_viewer_);
  }
  right_ = snapped(glm::normalize(right));
  up_ = glm::cross(toward_viewer_, right_);
}

int Camera::facing(const Plane& plane) const {
  const double sine = is_perspective() ? glm::dot(plane.normal, eye_) - plane.offset
                                       : glm::dot(plane.normal, toward_viewer_);
  if (std::abs(sine) <= kEdgeOnTolerance) return 0;
  return sine > 0 ? 1 : -1;
}

}  // namespace spoctree
