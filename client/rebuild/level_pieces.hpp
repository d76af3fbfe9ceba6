// The convex pieces of T_k, by node, to be looked at again and again: what no view changes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/plain_vector.hpp"
#include "common/base/progress_meter.hpp"
#include "common/base/small_count.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

/// The material of a leaf, or of a GREY node of the level looked at.
struct LeafPieces {
  std::uint32_t first_piece = 0;
  std::uint32_t piece_count = 0;
  std::uint32_t first_bound = 0;
  std::uint32_t bound_count = 0;
  std::uint32_t first_token = 0;
  std::uint32_t token_count = 0;
  std::uint16_t store = 0;  ///< which of LevelPieces' stores these are in
  /// BLACK, and no ancestor's plane cuts it: the piece is the cube, and has no corners of its own.
  bool is_whole_cube = false;
  bool is_frontier = false;  ///< GREY: only at the level looked at
};

/// What is more than this is BadInput. Less only to try it out.
struct PieceLimits {
  std::size_t leaves = (std::size_t{1} << 31) - 1;  ///< with pieces
  /// Of the pieces of a part of the tree; likewise expressions' tokens, and planes that bound
  /// leaves.
  std::size_t corners = kMostIn32Bits;
};

class LevelPieces {
 public:
  /// Those of T_level; levels beyond the tree mean its last level. REQUIRES, throws: as go_on_to.
  LevelPieces(const Octree& tree, std::uint32_t level, const ProgressShare& progress = {},
              const PieceLimits& limits = {})
      : LevelPieces(limits) {
    go_on_to(tree, level, progress);
  }

  /// The pieces of T_level from now on. If that is the next level, those of leaves found before are
  /// kept. In parallel; same tree and level, same pieces in their leaves. Time O(nodes that are
  /// new), each a few clips of a small polyhedron, and O(nodes of the last level before); memory
  /// O(nodes). Throws BadInput if there is more of anything than the limits say, or what `progress`
  /// throws; this can only be destroyed then. REQUIRES: a valid tree (validate.hpp) with at least
  /// one level, which begins with the levels that were there before.
  void go_on_to(const Octree& tree, std::uint32_t level, const ProgressShare& progress = {});

  std::uint32_t level() const { return level_; }
  /// The number of nodes with pieces.
  std::size_t leaf_count() const { return settled_.leaves.size() + frontier_.leaves.size(); }
  /// Nothing for WHITE nodes, for inner nodes, and for leaves without material within the
  /// ancestors' half-spaces.
  const LeafPieces* find(const NodeAddress& node) const {
    const std::uint32_t number = numbers_[node.level][node.index];
    if (number == kNone) return nullptr;
    return (number & kInFrontier) != 0 ? &frontier_.leaves[number & ~kInFrontier]
                                       : &settled_.leaves[number];
  }
  /// The corners of a leaf's piece, in universe coordinates.
  std::span<const Vec3> corners(const LeafPieces& leaf, std::uint32_t piece) const {
    const Store& store = store_of(leaf);
    const std::uint32_t* const begin = &store.corner_begin[leaf.first_piece + piece];
    return {store.corners.data() + begin[0], begin[1] - begin[0]};
  }
  /// CONCAVE and VERTEX leaves: their expression over their own planes, in preorder, without the
  /// splits that leave no interior on one side; the pieces are those of its in-cells, in this
  /// order. Nothing for other nodes.
  std::span<const std::uint32_t> expression(const LeafPieces& leaf) const {
    return {store_of(leaf).tokens.data() + leaf.first_token, leaf.token_count};
  }
  /// The planes of the table that bound the region of a node with an expression, or else the piece.
  std::span<const std::uint32_t> bounds(const LeafPieces& leaf) const {
    return {store_of(leaf).bounds.data() + leaf.first_bound, leaf.bound_count};
  }
  /// How many leaves and GREY nodes were visited so far, to find their pieces.
  std::uint64_t nodes_visited() const { return nodes_visited_; }

 private:
  static constexpr auto kNone = static_cast<std::uint32_t>(-1);
  static constexpr std::uint32_t kInFrontier = std::uint32_t{1} << 31;

  /// What is found in one part of the tree stays where it was found: it is most of all memory.
  struct Store {
    PlainVector<std::uint32_t> corner_begin;  // one more than there are pieces
    PlainVector<Vec3> corners;
    PlainVector<std::uint32_t> bounds;
    PlainVector<std::uint32_t> tokens;
  };
  struct Leaves {
    std::vector<LeafPieces> leaves;
    std::vector<Store> stores;
  };
  class Collector;

  const Store& store_of(const LeafPieces& leaf) const {
    return (leaf.is_frontier ? frontier_ : settled_).stores[leaf.store];
  }
  static std::vector<std::vector<Subtree>> divide(const Octree& tree, std::uint32_t level);
  std::vector<std::vector<Subtree>> divide_frontier(const Octree& tree) const;
  void gather(std::vector<Collector>& found);

  explicit LevelPieces(const PieceLimits& limits) : limits_(limits) {}

  PieceLimits limits_;
  std::uint32_t level_ = 0;
  std::vector<std::vector<std::uint32_t>> numbers_;  // by level and index
  Leaves settled_;                                   // leaves of all levels
  Leaves frontier_;                                  // GREY nodes of the level looked at
  std::vector<NodeAddress> frontier_nodes_;          // these are the leaves of
  std::uint64_t nodes_visited_ = 0;
};

}  // namespace spoctree
