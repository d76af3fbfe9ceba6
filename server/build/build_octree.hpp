// Solid -> octree: the one builder loop.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "common/tree/octree.hpp"
#include "server/build/sp_classifier.hpp"
#include "server/solid/solid.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

struct BuildOptions {
  SpRules rules;
  /// Called now and then with the fraction of the universe cube that is done.
  std::function<void(double)> progress;
};

/// A finished tree, with what the builder knows besides.
struct BuiltOctree {
  Octree tree;
  /// For the GREY nodes of each level, in order: a triangle of the solid that touches the node.
  std::vector<std::vector<std::uint32_t>> witnesses;
  /// Material in the leaves of each level, in cubed universe units.
  std::vector<double> leaf_volumes;
  /// The solid's boundary in the leaves and in the GREY nodes of each level, in squared universe
  /// units.
  std::vector<double> leaf_areas;
  std::vector<double> grey_areas;
  /// Nodes that became leaves only because of `max_depth`.
  std::size_t depth_limited_nodes = 0;
};

/// Builds the SP-Octree of a solid: exact, the same tree on every run. The tree's planes are the
/// solid's that occur in it, renumbered in order of first appearance. The levels' statements are
/// not filled: see certify.hpp. Time about linear in the nodes made.
BuiltOctree build_octree(const Solid& solid, const SolidQueries& queries,
                         const BuildOptions& options);

}  // namespace spoctree
