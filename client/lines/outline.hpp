// A convex piece seen from the viewer: one convex polygon.
#pragma once

#include <vector>

#include "client/lines/camera.hpp"
#include "common/geometry/polyhedron.hpp"

namespace spoctree {

/// Projects pieces. Holds working memory: use one per thread.
class OutlineFinder {
 public:
  /// REQUIRES: `planes` refers to a table that outlives the finder.
  OutlineFinder(const PlaneSet& planes, std::size_t table_size, const Camera& camera);

  /// Camera::facing of the plane, looked up.
  int facing(PlaneRef plane) const {
    const int facing = plane.is_wall() ? facing_walls_[plane.axis()] : facing_table_[plane.index()];
    return plane.is_flipped() ? -facing : facing;
  }

  /// The outline in picture coordinates, counter-clockwise; empty if no face faces the viewer. The
  /// polygon is that of the faces that do, so neighbouring pieces have their outlines' corners from
  /// the same points of space. O(corners).
  void find(const Polyhedron& piece, std::vector<Vec2>& outline);

 private:
  const Camera& camera_;
  std::vector<signed char> facing_table_;
  signed char facing_walls_[3];
  std::vector<std::uint32_t> next_;
};

}  // namespace spoctree
