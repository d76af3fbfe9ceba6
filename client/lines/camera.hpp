// The way from universe coordinates to the plane of the picture.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "common/geometry/plane.hpp"
#include "common/tree/pieces.hpp"

namespace spoctree {

using Vec2 = glm::dvec2;

/// An axis-aligned rectangle of the picture.
struct Rectangle {
  Vec2 lower{0.0};
  Vec2 upper{0.0};
};

/// A parallel or a perspective projection. Picture coordinates: x to the right, y upwards; universe
/// units, those of a perspective picture at the distance of its target.
class Camera {
 public:
  /// A parallel projection from the front, a little from the right and from above.
  Camera() : Camera(Vec3{0.55, -0.71, 0.44}) {}

  /// A parallel projection. `toward_viewer` points from the solid to the viewer, of any length; in
  /// the picture, `up` points upwards as far as it can: where it lies in the line of sight, +Y
  /// does, or else +Z. Throws UsageError if a vector is zero or not finite.
  explicit Camera(Vec3 toward_viewer, Vec3 up = {0, 0, 1});

  /// A perspective projection: a viewer at `eye` looks at `target`. Throws UsageError if the two
  /// are one point, or as above.
  static Camera perspective(Vec3 eye, Vec3 target, Vec3 up = {0, 0, 1});

  bool is_perspective() const { return focal_length_ > 0; }
  /// Perspective only.
  Vec3 eye() const { return eye_; }
  double focal_length() const { return focal_length_; }

  /// REQUIRES: for a perspective, depth(point) > 0.
  Vec2 project(Vec3 point) const {
    if (!is_perspective()) return {glm::dot(right_, point), glm::dot(up_, point)};
    const Vec3 from_eye = point - eye_;
    const double scale = -focal_length_ / glm::dot(toward_viewer_, from_eye);
    return {scale * glm::dot(right_, from_eye), scale * glm::dot(up_, from_eye)};
  }
  /// How far in front of the viewer a point is, along the axis of sight; 1 in parallel projections.
  double depth(Vec3 point) const {
    return is_perspective() ? glm::dot(toward_viewer_, eye_ - point) : 1;
  }
  /// What has less depth than this is not drawn; 0 in parallel projections.
  double least_depth() const { return least_depth_; }
  /// Greater for points nearer to the viewer.
  double nearness(Vec3 point) const { return glm::dot(toward_viewer_, point); }
  /// From a point to the viewer, of unit length.
  Vec3 toward_viewer_from(Vec3 point) const {
    return is_perspective() ? glm::normalize(eye_ - point) : toward_viewer_;
  }
  /// +1: the plane's outer side faces the viewer; -1: it looks away; 0: the plane is seen edge-on.
  int facing(const Plane& plane) const;

  /// Unit vectors, right-handed: right x up = toward_viewer (the axis of sight, backwards). Exact
  /// for axis-aligned views.
  Vec3 right() const { return right_; }
  Vec3 up() const { return up_; }
  Vec3 toward_viewer() const { return toward_viewer_; }

  /// For `walk_pieces`.
  Viewpoint viewpoint() const {
    return is_perspective() ? Viewpoint{eye_, 1} : Viewpoint{toward_viewer_, 0};
  }

 private:
  void turn(Vec3 toward_viewer, Vec3 up);

  Vec3 right_;
  Vec3 up_;
  Vec3 toward_viewer_;
  Vec3 eye_{0.0};
  double focal_length_ = 0;
  double least_depth_ = 0;
};

}  // namespace spoctree
