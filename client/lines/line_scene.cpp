#include "client/lines/line_scene.hpp"

#include <cmath>

#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

Creases creases_of(const Surface& surface) {
  Creases creases;
  creases.creases.reserve(surface.edges.size());
  creases.sides.reserve(surface.sides.size());
  for (const Surface::Edge& edge : surface.edges) {
    creases.creases.push_back(
        {surface.vertices[edge.a], surface.vertices[edge.b], edge.first_side, edge.side_count});
  }
  for (const Surface::Side& side : surface.sides) {
    creases.sides.push_back({surface.faces[side.face].plane, side.forward});
  }
  return creases;
}

}  // namespace

LineScene::LineScene(const Octree& tree, const Surface& surface, std::uint32_t level)
    : tree_(tree),
      diagonal_(std::sqrt(3.0) * 2 * tree.universe.half_side),
      creases_(creases_of(surface)),
      pieces_(tree, level),
      parts_(tree, level, creases_.creases, kCreaseTolerance * diagonal_),
      extents_(tree, pieces_, creases_.creases, parts_) {}

void LineScene::go_on_to(const Surface& surface, std::uint32_t level) {
  creases_ = creases_of(surface);
  pieces_.go_on_to(tree_, level);
  parts_ = CreaseParts(tree_, level, creases_.creases, kCreaseTolerance * diagonal_);
  extents_ = NodeExtents(tree_, pieces_, creases_.creases, parts_);
}

}  // namespace spoctree
