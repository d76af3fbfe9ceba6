#include "tests/support/judge_view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace spoctree {

namespace {

/// Of the focal length: nothing nearer to the plane through the eye is judged.
constexpr double kLeastDepthJudged = 1e-4;

}  // namespace

JudgeView JudgeView::parallel(Vec3 toward_viewer) {
  JudgeView view;
  view.viewer_ = toward_viewer;
  view.backwards_ = glm::normalize(toward_viewer);
  const Vec3 other = std::abs(view.backwards_.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  view.right_ = glm::normalize(glm::cross(other, view.backwards_));
  view.up_ = glm::cross(view.backwards_, view.right_);
  return view;
}

JudgeView JudgeView::perspective(Vec3 eye, Vec3 target, Vec3 up, double half_angle_deg) {
  JudgeView view = parallel(eye - target);
  view.viewer_ = eye;
  const Vec3 right = glm::cross(up, view.backwards_);
  if (glm::length(right) > 1e-9 * glm::length(up)) {
    view.right_ = glm::normalize(right);
    view.up_ = glm::cross(view.backwards_, view.right_);
  }
  view.focal_length_ = glm::distance(eye, target);
  view.least_depth_ = kLeastDepthJudged * view.focal_length_;
  view.slope_ = std::tan(half_angle_deg * std::acos(-1.0) / 180);
  return view;
}

double JudgeView::depth(Vec3 point) const {
  return is_perspective() ? glm::dot(backwards_, viewer_ - point) : 1;
}

glm::dvec2 JudgeView::project(Vec3 point) const {
  if (!is_perspective()) return {glm::dot(right_, point), glm::dot(up_, point)};
  const Vec3 from_eye = point - viewer_;
  const double scale = focal_length_ / depth(point);
  return {scale * glm::dot(right_, from_eye), scale * glm::dot(up_, from_eye)};
}

double JudgeView::scale(Vec3 point) const {
  return is_perspective() ? focal_length_ / depth(point) : 1;
}

std::optional<std::pair<double, double>> JudgeView::clip(Vec3 a, Vec3 b) const {
  double from = 0;
  double to = 1;
  const auto keep = [&](double at_a, double at_b) {  // where the linear function is positive
    if (at_a <= 0 && at_b <= 0) from = 2;
    if (at_a < 0 && at_b > 0) from = std::max(from, at_a / (at_a - at_b));
    if (at_a > 0 && at_b < 0) to = std::min(to, at_a / (at_a - at_b));
  };
  if (is_perspective()) {
    keep(depth(a) - least_depth_, depth(b) - least_depth_);
    for (const Vec3 axis : {right_, -right_, up_, -up_}) {
      const auto inside = [&](Vec3 p) { return slope_ * depth(p) - glm::dot(axis, p - viewer_); };
      keep(inside(a), inside(b));
    }
  }
  if (from >= to) return {};
  return std::pair(from, to);
}

double JudgeView::half_width() const {
  return is_perspective() ? slope_ * focal_length_ : std::numeric_limits<double>::infinity();
}

}  // namespace spoctree
