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

  /// True if the outer side of the plane faces the viewer.
  bool faces_viewer(PlaneRef plane) const {
    const bool front =
        plane.is_wall() ? facing_walls_[plane.axis()] == 1 : facing_table_[plane.index()] == 1;
    const bool back =
        plane.is_wall() ? facing_walls_[plane.axis()] == -1 : facing_table_[plane.index()] == -1;
    return plane.is_flipped() ? back : front;
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
