// Solid -> octree: the one builder loop.
#pragma once

#include <cstdint>
#include <vector>

#include "common/base/progress_meter.hpp"
#include "common/tree/octree.hpp"
#include "server/build/classifier.hpp"
#include "server/build/partial_cell.hpp"
#include "server/solid/solid.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

/// A tree may have so many nodes, and so many more for each triangle of the solid. Parts and scans
/// have 5 to 30 a triangle; what comes close to itself without touching has as many as the cells it
/// takes to tell its sides apart.
inline constexpr std::uint64_t kMostNodes = 2'000'000;
inline constexpr std::uint64_t kMostNodesPerTriangle = 100;

/// A classical tree has as many nodes as its depth asks for: about six times the cells that the
/// surface passes through. Some gigabytes are enough for anyone.
inline constexpr std::uint64_t kMostClassicalNodes = 40'000'000;

struct BuildOptions {
  TreeRules rules;
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
  /// Of an SP-Octree: material in the leaves of each level, in cubed universe units.
  std::vector<double> leaf_volumes;
  /// Of an SP-Octree: the solid's boundary in the leaves of each level, in squared universe units.
  std::vector<double> leaf_areas;
  /// Of a classical tree: the leaves of each level that are not what the solid is in their cell, in
  /// order. None in an SP-Octree, which is exact.
  std::vector<std::vector<PartialCell>> partial_cells;
  bool is_classical = false;
  /// Nodes that became leaves only because of `max_depth`.
  std::size_t depth_limited_nodes = 0;
};

/// Builds the tree of a solid, in parallel: exact (a classical one: each cell is what its rules
/// say), the same on every run and any number of threads. An SP-Octree's planes are the solid's
/// that occur in it, renumbered in order of first appearance; in a classical tree, eight siblings
/// of one colour are one leaf. The levels' statements are not filled: see certify.hpp. Time about
/// linear in the nodes made. Throws BadInput (without a file's name) for a tree beyond the limits
/// above, and for a classical one in which nothing is left of the solid.
BuiltOctree build_octree(const Solid& solid, const SolidQueries& queries,
                         const BuildOptions& options);

}  // namespace spoctree
