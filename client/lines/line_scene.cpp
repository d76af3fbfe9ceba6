#include "client/lines/line_scene.hpp"

#include <cmath>

#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

/// The shares of the steps, where there are a million faces.
constexpr double kFindingPieces = 0.9;
constexpr double kDistributing = 0.06;
constexpr double kMeasuring = 0.04;

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

LineScene::LineScene(const Octree& tree, const Surface& surface, std::uint32_t level,
                     const ProgressShare& progress)
    : tree_(tree),
      diagonal_(std::sqrt(3.0) * 2 * tree.universe.half_side),
      creases_(creases_of(surface)),
      pieces_(tree, level, progress.part(kFindingPieces)),
      parts_(tree, level, creases_.creases, kCreaseTolerance * diagonal_,
             progress.part(kDistributing)),
      extents_(tree, pieces_, creases_.creases, parts_, progress.part(kMeasuring)) {}

void LineScene::go_on_to(const Surface& surface, std::uint32_t level,
                         const ProgressShare& progress) {
  creases_ = creases_of(surface);
  pieces_.go_on_to(tree_, level, progress.part(kFindingPieces));
  parts_ = CreaseParts(tree_, level, creases_.creases, kCreaseTolerance * diagonal_,
                       progress.part(kDistributing));
  extents_ = NodeExtents(tree_, pieces_, creases_.creases, parts_, progress.part(kMeasuring));
}

}  // namespace spoctree
