// Boxes that are filled and hollowed out one after the other -> the boundary of what is left.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "tools/model/polygon_mesh.hpp"

namespace spoctree::model {

/// A solid of axis-aligned boxes.
class BoxSolid {
 public:
  /// Fills a box, from its lowest to its highest corner.
  void fill(const glm::dvec3& low, const glm::dvec3& high) { boxes_.push_back({low, high, true}); }
  /// Hollows a box out.
  void hollow(const glm::dvec3& low, const glm::dvec3& high) {
    boxes_.push_back({low, high, false});
  }

  /// Its boundary, cut into rectangles by the planes of all faces of all boxes, so that corners
  /// meet corners. REQUIRES: what is filled nowhere touches in an edge or a corner only.
  /// O(boxes^4).
  PolygonMesh mesh() const;

 private:
  struct Box {
    glm::dvec3 low;
    glm::dvec3 high;
    bool is_full;
  };
  std::vector<Box> boxes_;
};

}  // namespace spoctree::model
