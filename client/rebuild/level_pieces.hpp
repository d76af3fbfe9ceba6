// The convex pieces of T_k, by node, to be looked at again and again: what no view changes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

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
  /// BLACK, and no ancestor's plane cuts it: the piece is the cube, and has no corners of its own.
  bool is_whole_cube = false;
};

class LevelPieces {
 public:
  /// The pieces of T_level; levels beyond the tree mean its last level. In parallel; same tree,
  /// same pieces. Time O(nodes), each a few clips of a small polyhedron; memory O(nodes). REQUIRES:
  /// a valid tree (validate.hpp) with at least one level.
  LevelPieces(const Octree& tree, std::uint32_t level);

  std::uint32_t level() const { return level_; }
  /// The number of nodes with pieces.
  std::size_t leaf_count() const { return leaves_.size(); }
  /// Nothing for WHITE nodes, for inner nodes, and for leaves without material within the
  /// ancestors' half-spaces.
  const LeafPieces* find(const NodeAddress& node) const {
    const std::uint32_t number = numbers_[node.level][node.index];
    return number == kNone ? nullptr : &leaves_[number];
  }
  /// The corners of a leaf's piece, in universe coordinates.
  std::span<const Vec3> corners(const LeafPieces& leaf, std::uint32_t piece) const {
    const std::uint32_t* const begin = &corner_begin_[leaf.first_piece + piece];
    return {corners_.data() + begin[0], begin[1] - begin[0]};
  }
  /// CONCAVE and VERTEX leaves: their expression over their own planes, in preorder, without the
  /// splits that leave no interior on one side; the pieces are those of its in-cells, in this
  /// order. Nothing for other nodes.
  std::span<const std::uint32_t> expression(const LeafPieces& leaf) const {
    return {tokens_.data() + leaf.first_token, leaf.token_count};
  }
  /// The planes of the table that bound the region of a node with an expression, or else the piece.
  std::span<const std::uint32_t> bounds(const LeafPieces& leaf) const {
    return {bounds_.data() + leaf.first_bound, leaf.bound_count};
  }

 private:
  static constexpr auto kNone = static_cast<std::uint32_t>(-1);

  std::uint32_t level_;
  std::vector<std::vector<std::uint32_t>> numbers_;  // by level and index
  std::vector<LeafPieces> leaves_;
  std::vector<std::uint32_t> corner_begin_;
  std::vector<Vec3> corners_;
  std::vector<std::uint32_t> bounds_;
  std::vector<std::uint32_t> tokens_;
};

}  // namespace spoctree
