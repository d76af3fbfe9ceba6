// Planes that nearly meet in the corners of a surface -> planes that do.
#pragma once

#include <array>

#include "server/solid/flat_groups.hpp"

namespace spoctree {

/// Ways on which corners reach the planes around them, if they do: for each vertex, universe units.
struct JointFit {
  std::vector<std::array<double, 3>> ways;
};

/// More than three planes meet in many a corner: fitted one by one, they miss each other by about
/// the noise of the corners. This moves the planes of the groups that are not exact until they
/// meet in points near the corners again, as near as may be in the sense of least squares over all
/// corners. Where that would move a corner by `most_move` or more, or planes do not meet at all,
/// the triangles around the corner leave the smallest of its groups. What is left apart then, the
/// caller finds out corner by corner.
///
/// Groups that share corners, directly or over others, are solved together (JointFitter), again and
/// again until no corner is in conflict, 24 times at most.
JointFit fit_jointly(const FlatSurface& surface, FlatGroups& groups, double most_move);

}  // namespace spoctree
