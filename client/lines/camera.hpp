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

/// A parallel projection. Picture coordinates are universe units, x to the right, y upwards.
class Camera {
 public:
  /// Looks from the front, a little from the right and from above.
  Camera() : Camera(Vec3{0.55, -0.71, 0.44}) {}

  /// `toward_viewer` points from the solid to the viewer, of any length. Up in the picture is +Z,
  /// or +Y for views along Z. Throws UsageError if the direction is zero or not finite.
  explicit Camera(Vec3 toward_viewer);

  Vec2 project(Vec3 point) const { return {glm::dot(right_, point), glm::dot(up_, point)}; }
  /// Greater for points nearer to the viewer.
  double nearness(Vec3 point) const { return glm::dot(toward_viewer_, point); }
  /// +1: the plane's outer side faces the viewer; -1: it looks away; 0: the plane is seen edge-on.
  int facing(const Plane& plane) const;

  /// Unit vectors, right-handed: right x up = toward_viewer. Exact for axis-aligned views.
  Vec3 right() const { return right_; }
  Vec3 up() const { return up_; }
  Vec3 toward_viewer() const { return toward_viewer_; }

  /// For `walk_pieces`.
  Viewpoint viewpoint() const { return {toward_viewer_, 0}; }

 private:
  Vec3 right_;
  Vec3 up_;
  Vec3 toward_viewer_;
};

}  // namespace spoctree
