// The GREY regions of a level -> how far the level's solid can be from the true one.
#pragma once

#include "server/build/level_survey.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

/// A certified bound of a level's error, in universe units: a branch-and-bound maximum of the
/// distance from the regions to the solid.
///
/// T_k differs from the solid in the GREY nodes of level k only, and their descendants say where:
/// what a plane of a deeper node cuts off, a WHITE leaf, the out-cells of an expression. All of
/// these convex parts is beyond the solid, so each of their points is at a distance that is
/// attained. Nodes are opened, and parts divided box by box, best bound first, until the bound is
/// within kErrorBoundRatio of a distance that is attained, or a limit of work is reached. What is
/// material is never looked into, however much boundary T_k and the solid share. Rounding is added
/// to the bound.
double error_bound(const GreyRegions& regions, const BuiltOctree& built, const Solid& solid,
                   const SolidQueries& queries);

}  // namespace spoctree
