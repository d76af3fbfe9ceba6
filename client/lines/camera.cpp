#include "client/lines/camera.hpp"

#include <algorithm>
#include <cmath>

#include "common/base/errors.hpp"
#include "common/geometry/tolerances.hpp"

namespace spoctree {

Camera::Camera(Vec3 toward_viewer) {
  const double largest =
      std::max({std::abs(toward_viewer.x), std::abs(toward_viewer.y), std::abs(toward_viewer.z)});
  if (!(largest > 0) || !std::isfinite(toward_viewer.x) || !std::isfinite(toward_viewer.y) ||
      !std::isfinite(toward_viewer.z)) {
    throw UsageError("the direction of view must be finite and not zero");
  }
  // Scaled first, so that the squares neither overflow nor vanish.
  toward_viewer_ = glm::normalize(toward_viewer / largest);
  const double off_axis = std::hypot(toward_viewer_.x, toward_viewer_.y);
  if (off_axis < kEdgeOnTolerance) {
    toward_viewer_ = {0, 0, toward_viewer_.z > 0 ? 1 : -1};
    up_ = {0, 1, 0};
    right_ = {toward_viewer_.z, 0, 0};
    return;
  }
  right_ = Vec3{-toward_viewer_.y, toward_viewer_.x, 0} / off_axis;
  up_ = glm::cross(toward_viewer_, right_);
}

int Camera::facing(const Plane& plane) const {
  const double sine = glm::dot(plane.normal, toward_viewer_);
  if (std::abs(sine) <= kEdgeOnTolerance) return 0;
  return sine > 0 ? 1 : -1;
}

}  // namespace spoctree
