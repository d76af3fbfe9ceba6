// What the server certifies about every level of a classical tree.
#pragma once

#include "server/build/build_octree.hpp"

namespace spoctree {

/// Fills the statement of every level of a complete classical tree.
///
/// Volumes and areas are those of the cubes (measure_cubes): of the model that the tree is, not of
/// the solid that it stands for. The error bound is about the solid, and holds in both directions:
/// no point of T_k is farther from the solid, no point of the solid farther from T_k.
///
/// T_k reaches beyond the solid in the cells that the boundary passes through, GREY nodes of level
/// k and BLACK leaves of levels 0..k; the solid reaches beyond T_k in WHITE leaves only. (Its
/// distance is taken from the BLACK leaves alone, also at the levels before, which have more.) Both
/// searches go best first, until the bound is within kErrorBoundRatio of a distance that is
/// attained, or a limit of work is reached. In parallel, the same for any number of threads.
/// O(nodes * depth) and the search.
void certify_cubes(BuiltOctree& built, const Solid& solid, const SolidQueries& queries,
                   const ProgressReport& progress);

}  // namespace spoctree
