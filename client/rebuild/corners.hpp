// Tree -> the corners of its solid's boundary, as planes that meet.
//
// The boundary is known from its corners: on every line in which two planes meet, edges begin and
// end in corners. The corners of any sum of polyhedra are the sum of theirs, and a corner is named
// by its planes, exactly. So every cell says where its material has corners, and almost everything
// cancels: what two cells share, and what a wall cuts off a flat face or an edge.
//
// From T_k to T_k+1 only the GREY nodes of level k change: what the leaves say is kept as one sum,
// what the GREY nodes say is added to it for the level at hand.
#pragma once

#include <cstdint>
#include <vector>

#include "client/rebuild/carriers.hpp"
#include "client/rebuild/sorted_corners.hpp"
#include "common/base/progress_meter.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

/// The corners of T_0, T_1, ..., as far as wanted: each leaf is visited once.
class LevelCorners {
 public:
  /// Goes on to T_level. REQUIRES: level < tree.levels.size(); the tree begins with the levels that
  /// were gone on to so far; the carriers have the planes of them and of the new ones. In parallel.
  /// O(nodes of the new levels + corners).
  void advance(const Octree& tree, std::uint32_t level, const Carriers& carriers,
               const ProgressShare& progress = {});

  /// The corners of T_level, each once, by their planes in ascending order.
  std::vector<CornerCount> corners() const { return add_sorted_corners(settled_, open_); }

  /// How many cells were visited so far: every leaf once, and the GREY nodes of the levels that
  /// were stopped at; without those outside of their ancestors' planes.
  std::uint64_t cells_visited() const { return cells_visited_; }

 private:
  std::vector<CornerCount> settled_;  // of the leaves
  std::vector<CornerCount> open_;     // of the GREY nodes of the last level
  std::vector<Subtree> frontier_{1};  // these nodes; at first, the root
  std::uint32_t level_count_ = 0;     // that were gone on to
  std::uint64_t cells_visited_ = 0;
};

}  // namespace spoctree
