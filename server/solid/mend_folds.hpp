// Triangles that lie upside down in their group's plane -> other diagonals.
#pragma once

#include "server/solid/flat_groups.hpp"

namespace spoctree {

/// A surface whose corners have moved onto the planes of their groups.
struct SettledSurface {
  std::span<const GridPoint> points;
  const FlatGroups* groups;
  std::vector<Corners> triangles;
  std::vector<Corners> neighbours;
};

/// Corners in a row on the rim of a flat face, with a needle of a triangle between them, end up on
/// one line: the needle has no area any more, or less than none. Of the two triangles beside an
/// edge within one group the edge is turned (it then joins the other two corners) where that makes
/// more of them thicker than rounding to the grid, or at least upright: counter-clockwise in their
/// group's plane, strictly, exactly, seen along the axis nearest to its normal. A group of upright
/// triangles has no folds.
/// `suspects` are triangles of groups that may not be upright; left there are those that are not.
/// Returns the triangles that were changed, in order.
std::vector<std::uint32_t> mend_folds(SettledSurface& surface,
                                      std::vector<std::uint32_t>& suspects);

}  // namespace spoctree
