// What a viewer sees of a boundary's creases, by rays: slow, simple, and made of nothing that the
// drawing program uses.
#pragma once

#include <glm/vec2.hpp>

#include "client/lines/visible_line.hpp"
#include "client/rebuild/surface.hpp"

namespace spoctree {

class SightOracle {
 public:
  /// `toward_viewer` of any length.
  SightOracle(const Surface& surface, const PlaneSet& planes, Vec3 toward_viewer);

  /// True if a ray that leaves `point` of a line along `direction` towards the viewer, a hair
  /// beside the line on either side, meets no face.
  bool is_visible(Vec3 point, Vec3 direction) const;

  /// True if, in the picture, `point` is nearer than `distance` to a crease that is not (nearly)
  /// the line along `direction` itself: there, visibility may change.
  bool is_near_other_crease(Vec3 point, Vec3 direction, double distance) const;

  /// True if the edge touches the inside of a flat face that does not end there: from that face's
  /// side nothing is to be seen of it.
  bool touches_flat_face(const Surface::Edge& edge) const;

  glm::dvec2 project(Vec3 point) const;
  const Surface& surface() const { return surface_; }

 private:
  bool ray_is_free(Vec3 from) const;
  bool is_inside(const Surface::Face& face, Vec3 point, Vec3 x_axis, Vec3 y_axis) const;

  const Surface& surface_;
  const PlaneSet planes_;
  Vec3 toward_viewer_;
  Vec3 x_axis_;
  Vec3 y_axis_;
};

/// The disagreements of a drawing with the oracle, one text each (at most 10): points of creases
/// that should be seen where no line is; points of lines that should not be seen; lines on lines.
/// `samples` points are tried on each crease and each line, and the numbers of points that counted
/// are added to `tried`.
std::vector<std::string> compare(const VisibleLines& lines, const SightOracle& oracle, int samples,
                                 std::size_t& tried);

}  // namespace spoctree
