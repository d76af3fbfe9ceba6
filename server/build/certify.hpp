// What the server certifies about every level: volumes, and how far T_k can be from the solid.
#pragma once

#include "server/build/build_octree.hpp"

namespace spoctree {

/// Fills the statement of every level of a complete tree.
///
/// Inner volumes are the material in the leaves, outer ones add the regions of GREY nodes; inner
/// areas are the boundary in the leaves, outer ones the whole boundary. The error bound of level k
/// is an upper bound of the one-sided Hausdorff distance from T_k to the solid: T_k differs from
/// the solid only in the GREY regions of level k (level_survey.hpp, error_bound.hpp). In parallel;
/// the same statements for any number of threads. O(nodes) clips, and a search per level.
void certify(BuiltOctree& built, const Solid& solid, const SolidQueries& queries,
             const ProgressReport& progress = {});

/// The bound is at most this times the true distance, unless the limit of work was reached.
inline constexpr double kErrorBoundRatio = 1.1;

}  // namespace spoctree
