// The GREY regions of a level -> how far the level's solid can be from the true one.
#pragma once

#include "common/tree/octree.hpp"
#include "server/build/level_survey.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

/// A certified bound of a level's error, in universe units: a branch-and-bound maximum of the
/// distance from the regions to the solid. The boxes in question are subdivided, best bound first,
/// until the bound is within kErrorBoundRatio of a distance that is attained, or a limit of work is
/// reached. Rounding is added to the bound.
double error_bound(const GreyRegions& regions, const PlaneSet& planes, const SolidQueries& queries);

}  // namespace spoctree
