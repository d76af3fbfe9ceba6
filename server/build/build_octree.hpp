// Solid -> octree: the one builder loop.
#pragma once

#include <cstdint>
#include <vector>

#include "common/base/progress_meter.hpp"
#include "common/tree/octree.hpp"
#include "server/build/sp_classifier.hpp"
#include "server/solid/solid.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

/// A tree may have so many nodes, and so many more for each triangle of the solid. Parts and scans
/// have 5 to 30 a triangle; what comes close to itself without touching has as many as the cells it
/// takes to tell its sides apart.
inline constexpr std::uint64_t kMostNodes = 2'000'000;
inline constexpr std::uint64_t kMostNodesPerTriangle = 100;

struct BuildOptions {
  SpRules rules;
  /// Told how much of the work is done, now and then, by any thread (see ProgressMeter).
  ProgressReport progress;
  /// A cell with at most so many fragments is built by one thread, with all that is below it. The
  /// result does not depend on it.
  std::size_t fragments_per_job = 2048;
};

/// A finished tree, with what the builder knows besides.
struct BuiltOctree {
  Octree tree;
  /// For the GREY nodes of each level, in order: a triangle of the solid that touches the node.
  std::vector<std::vector<std::uint32_t>> witnesses;
  /// Material in the leaves of each level, in cubed universe units.
  std::vector<double> leaf_volumes;
  /// The solid's boundary in the leaves of each level, in squared universe units.
  std::vector<double> leaf_areas;
  /// Nodes that became leaves only because of `max_depth`.
  std::size_t depth_limited_nodes = 0;
};

/// Builds the SP-Octree of a solid, in parallel: exact, the same tree on every run and any number
/// of threads. The tree's planes are the solid's that occur in it, renumbered in order of first
/// appearance. The levels' statements are not filled: see certify.hpp. Time about linear in the
/// nodes made. Throws BadInput (without a file's name) for a tree beyond the limits above.
BuiltOctree build_octree(const Solid& solid, const SolidQueries& queries,
                         const BuildOptions& options);

}  // namespace spoctree
