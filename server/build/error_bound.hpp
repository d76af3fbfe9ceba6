// The GREY regions of all levels -> how far each level's solid can be from the true one.
#pragma once

#include <span>
#include <vector>

#include "server/build/level_survey.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

/// Certified bounds of the levels' errors, in universe units: for each level a branch-and-bound
/// maximum of the distance from its regions to the solid. `regions` are those of all levels.
///
/// T_k differs from the solid in the GREY nodes of level k only, and their descendants say where:
/// what a plane of a deeper node cuts off, a WHITE leaf, the out-cells of an expression. All of
/// these convex parts is beyond the solid, so each of their points is at a distance that is
/// attained. Nodes are opened, and parts divided box by box, best bound first, until the bound is
/// within kErrorBoundRatio of a distance that is attained, or a limit of work is reached. What is
/// material is never looked into, however much boundary T_k and the solid share. Rounding is added
/// to the bound.
///
/// What a plane or leaf of level j takes away belongs to all T_k before j. So no node is opened for
/// more than one level, the first that asks: what is found in it is kept for those after. In the
/// worst case, where it is the noise of all faces that makes the error, O(nodes) and what dividing
/// the leaves takes.
std::vector<double> error_bounds(std::span<const GreyRegions> regions, const BuiltOctree& built,
                                 const Solid& solid, const SolidQueries& queries);

}  // namespace spoctree
