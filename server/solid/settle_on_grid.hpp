// What the grid of the universe cube cannot tell apart, out of a soup: points nearer to each other
// than one of its steps, and triangles that are lines on it.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

struct GridSettlement {
  std::size_t merged_points = 0;
  std::size_t dropped_faces = 0;
  /// One line for each kind of change: how often, and the first places. Empty: nothing was changed.
  std::vector<std::string> changes;
};

/// Makes points one whose coordinates differ by less than a step of the grid (2^-52 of the universe
/// frame), since rounding to it may or may not keep them apart. Where such points form a chain that
/// reaches farther than kWidestSettling steps, only those are made one that the grid rounds to the
/// same place. Either way who belongs together does not depend on the order of the points. They
/// become the one among them that most corners have. Faces that have collapsed by this, and
/// triangles that are on one line on the grid but were none in the file, are dropped, their points
/// handed to the neighbours (drop_needles). Triangles without area in the file are left for the
/// judge. What has no valid extent is left alone.
///
/// Linear, as far as points are apart (one look at a hash table for each); n log n in what is not.
/// REQUIRES: soup as from read_mesh. The points that are left over are removed.
GridSettlement settle_on_grid(PolygonSoup& soup);

inline constexpr int kWidestSettling = 2;

}  // namespace spoctree
