// A convex piece seen from the viewer: one convex polygon.
#pragma once

#include <vector>

#include "client/lines/camera.hpp"
#include "common/geometry/polyhedron.hpp"

namespace spoctree {

/// Leaves out corners of a convex polygon that are nearer than `tolerance` to the one before, and
/// those next to a short edge that stand off the straight line past them by less than a fraction of
/// it: between such corners, rounding decides where the edge points, and an edge that points astray
/// cuts off what is far away. Nothing is left of a polygon without area.
void straighten(std::vector<Vec2>& polygon, double tolerance);

/// Projects pieces. Holds working memory: use one per thread.
class OutlineFinder {
 public:
  /// `tolerance` as in `straighten`. REQUIRES: `camera` outlives the finder.
  OutlineFinder(const PlaneSet& planes, std::size_t table_size, const Camera& camera,
                double tolerance);

  /// Camera::facing of the plane, looked up.
  int facing(PlaneRef plane) const {
    const int facing = plane.is_wall() ? facing_walls_[plane.axis()] : facing_table_[plane.index()];
    return plane.is_flipped() ? -facing : facing;
  }

  /// The outline in picture coordinates, counter-clockwise; empty if no face faces the viewer. The
  /// polygon is that of the faces that do, so neighbouring pieces have their outlines' corners from
  /// the same points of space. Straightened. O(corners).
  void find(const Polyhedron& piece, std::vector<Vec2>& outline);

 private:
  const Camera& camera_;
  double tolerance_;
  std::vector<signed char> facing_table_;
  signed char facing_walls_[3];
  std::vector<std::uint32_t> next_;
};

}  // namespace spoctree
