// A view as judges of drawings see it: their own projection, apart from the drawer's cameras.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <utility>

#include "common/geometry/universe.hpp"

namespace spoctree {

class JudgeView {
 public:
  static JudgeView parallel(Vec3 toward_viewer);
  /// What lies more than `half_angle_deg` off the axis of sight, in either direction of the
  /// picture, is not judged.
  static JudgeView perspective(Vec3 eye, Vec3 target, Vec3 up = {0, 0, 1},
                               double half_angle_deg = 80);

  bool is_perspective() const { return focal_length_ > 0; }
  /// The eye, or the direction towards the viewer.
  Vec3 viewer() const { return viewer_; }

  /// In front of the eye; 1 in parallel projections.
  double depth(Vec3 point) const;
  /// As if the picture stood at the target. REQUIRES: depth(point) > 0.
  glm::dvec2 project(Vec3 point) const;
  /// The length in the picture of a unit of length across the sight at `point`.
  double scale(Vec3 point) const;
  /// What part of a segment a + t (b - a), 0 <= t <= 1, is in the window.
  std::optional<std::pair<double, double>> clip(Vec3 a, Vec3 b) const;
  /// The window's half width; infinite in parallel projections.
  double half_width() const;

 private:
  Vec3 viewer_{0.0};
  Vec3 right_{0.0};
  Vec3 up_{0.0};
  Vec3 backwards_{0.0};
  double focal_length_ = 0;
  double least_depth_ = 0;
  double slope_ = 0;  ///< of the window's walls
};

}  // namespace spoctree
