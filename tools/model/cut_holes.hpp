// A planar face with holes -> simple polygons on the same corner points.
#pragma once

#include <vector>

#include "tools/model/polygon_mesh.hpp"

namespace spoctree::model {

/// Splits the face inside `outer` and outside `holes` into simple polygons by cuts from corner to
/// corner: two cuts per hole, the shortest one and one at the opposite end of the hole. No point is
/// added and no edge divided, so the neighbours of the face stay as they are.
/// REQUIRES: all corners in one plane; the material on the left of every loop seen from outside
/// (`outer` counterclockwise, holes clockwise); loops that do not touch each other. Corners should
/// have few digits: orientations are computed in plain double.
/// Throws std::logic_error if some hole has no two cuts, as holes can hide each other.
/// O(holes * corners^3), for faces made by hand.
std::vector<Loop> cut_holes(const std::vector<glm::dvec3>& points, Loop outer,
                            std::vector<Loop> holes);

}  // namespace spoctree::model
