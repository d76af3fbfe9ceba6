// The one tree of the product: the server's whole tree and a client's prefix of it.
//
// Nodes stand breadth-first, a level is a contiguous slice, and children are implied by position:
// the k-th GREY node of a level owns entries 8k .. 8k+7 of the next. Octant label of a child =
// x + 2y + 4z with one bit per axis (0 = lower half). A plane stands once in a table, in the order
// of first appearance; nodes hold references.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/geometry/plane.hpp"
#include "common/tree/node_kind.hpp"

namespace spoctree {

/// What the builder certifies about T_k, the solid of the levels 0..k (every GREY node of level k
/// replaced by C n A n P). Model units. Volumes and areas are about the last T, which is the solid
/// itself for an SP-Octree, and only near it for a classical octree.
struct LevelStatement {
  /// No point of T_k is farther than this from the solid, and none of the solid farther from T_k
  /// (which is 0 wherever T_k contains the solid: in SP-Octrees, and with full partial cells).
  double error_bound = 0;
  /// Volume that is certainly material: the leaves of levels 0..k.
  double inner_volume = 0;
  /// Volume of T_k. The two are equal at the last level.
  double outer_volume = 0;
  /// Area of the solid's boundary that lies in the leaves of levels 0..k.
  double inner_area = 0;
  /// The area of the solid's whole boundary is at most this (up to the rounding of a sum of
  /// doubles). Equal to inner_area at the last level.
  double outer_area = 0;

  bool operator==(const LevelStatement&) const = default;
};

/// A VERTEX node's boolean expression: a binary space partition over the node's own planes, in
/// preorder. kOutToken and kInToken are leaves; kFirstPlaneToken + i splits by the node's i-th
/// plane and is followed by the expression inside the plane's half-space, then the one outside.
inline constexpr std::uint32_t kOutToken = 0;
inline constexpr std::uint32_t kInToken = 1;
inline constexpr std::uint32_t kFirstPlaneToken = 2;

/// One level of nodes, column by column.
struct Level {
  std::vector<NodeKind> kinds;
  /// For GREY nodes, the index of the first child in the next level; for others unused.
  std::vector<std::uint32_t> first_child;
  std::vector<std::uint32_t> reference_begin{0};  ///< size() + 1 offsets into `references`
  std::vector<std::uint32_t> references;          ///< indices in the plane table
  std::vector<std::uint32_t> token_begin{0};      ///< size() + 1 offsets into `tokens`
  std::vector<std::uint32_t> tokens;              ///< expressions of the VERTEX nodes
  std::uint32_t grey_count = 0;
  LevelStatement statement;

  std::uint32_t size() const { return static_cast<std::uint32_t>(kinds.size()); }
  std::span<const std::uint32_t> planes_of(std::uint32_t node) const {
    return {references.data() + reference_begin[node],
            reference_begin[node + 1] - reference_begin[node]};
  }
  std::span<const std::uint32_t> expression_of(std::uint32_t node) const {
    return {tokens.data() + token_begin[node], token_begin[node + 1] - token_begin[node]};
  }
  /// Appends a node and links it (a GREY node gets the next eight entries of the next level).
  void append(NodeKind kind, std::span<const std::uint32_t> planes,
              std::span<const std::uint32_t> expression = {});
  std::array<std::uint32_t, kNodeKindCount> count_kinds() const;
};

/// An SP-Octree, whole or the first levels of one. Plain data: `validate` (validate.hpp) says
/// whether it is one.
struct Octree {
  Universe universe;
  std::vector<Plane> planes;
  std::vector<Level> levels;

  PlaneSet plane_set() const { return {planes, universe.half_side}; }
  /// Number of entries that level `levels.size()` must have: 1 for the root, then 8 per GREY node.
  std::uint64_t next_level_size() const {
    return levels.empty() ? 1 : std::uint64_t{8} * levels.back().grey_count;
  }
  /// True if no GREY node waits for children.
  bool is_complete() const { return !levels.empty() && levels.back().grey_count == 0; }
};

}  // namespace spoctree
