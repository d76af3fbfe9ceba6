#include "server/build/classical_classifier.hpp"

#include <algorithm>

#include "server/build/cell_contents.hpp"

namespace spoctree {

namespace {

/// The corners are exactly on the walls they are pinned to, so this is no matter of rounding.
bool lies_in_a_wall(std::span<const FragmentCorner> corners) {
  for (int axis = 0; axis < 3; ++axis) {
    const double wall = corners.front().position[axis];
    const bool all_on_it = std::all_of(corners.begin(), corners.end(), [&](const auto& corner) {
      return ((corner.pinned >> axis) & 1) != 0 && corner.position[axis] == wall;
    });
    if (all_on_it) return true;
  }
  return false;
}

bool is_mixed(const FragmentList& boundary) {
  return std::any_of(
      boundary.fragments.begin(), boundary.fragments.end(),
      [&](const Fragment& fragment) { return !lies_in_a_wall(boundary.corners_of(fragment)); });
}

}  // namespace

void ClassicalClassifier::classify(Cell& cell, Decision& decision) {
  decision.clear();
  if (!is_mixed(cell.boundary)) {
    decision.kind = is_all_material(solid_, queries_, cell) ? NodeKind::Black : NodeKind::White;
    return;
  }
  decision.witness = triangle_near_centre(solid_, cell, cell.boundary.fragments);
  if (cell.depth < rules_.max_depth) {
    decision.kind = NodeKind::Grey;
    return;
  }
  decision.is_depth_limited = true;
  decision.kind = is_full_at_the_limit(cell) ? NodeKind::Black : NodeKind::White;
}

bool ClassicalClassifier::is_full_at_the_limit(const Cell& cell) const {
  if (rules_.partial != PartialCells::Half) return rules_.partial == PartialCells::Full;
  return queries_.side_of(cell.centre(solid_)) != SolidQueries::Side::Out;
}

}  // namespace spoctree
