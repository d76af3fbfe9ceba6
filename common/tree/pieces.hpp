// A tree's material as disjoint convex pieces, in front-to-back order if asked.
//
// BLACK leaf: cube n ancestors' half-spaces; CONVEX leaf: the same n its planes; CONCAVE and VERTEX
// leaves: the in-cells of their expression; a GREY node of the last level looked at: cube n
// ancestors' n its own half-spaces. The pieces of levels 0..k make up T_k (see octree.hpp).
#pragma once

#include <optional>
#include <vector>

#include "common/geometry/polyhedron.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

/// Where the picture is seen from, in universe coordinates: a point (w = 1), or for a parallel
/// projection the direction towards the viewer (w = 0). Any finite doubles; no other w.
struct Viewpoint {
  Vec3 xyz{0.0};
  double w = 0;
};

/// Called for what `walk_pieces` meets. All polyhedra are in universe coordinates and valid during
/// the call only.
class PieceVisitor {
 public:
  virtual ~PieceVisitor() = default;
  /// A node that is not WHITE is about to be visited; return false to skip its whole subtree.
  /// `region` is its cube n the ancestors' half-spaces, which has an interior: nodes whose region
  /// has none are passed over.
  virtual bool enter(const NodeAddress&, NodeKind, const Polyhedron& /*region*/) { return true; }
  /// A GREY node above the last level looked at: its region clipped by its own planes, which has an
  /// interior. Comes between `enter` and the children.
  virtual void inner(const NodeAddress&, const Polyhedron& /*region*/) {}
  /// A convex piece of material. `part` counts the pieces of one node from 0.
  virtual void piece(const NodeAddress&, NodeKind, std::uint32_t part, const Polyhedron&) = 0;
  /// The node entered last, and not left yet, is done. Not called for skipped nodes.
  virtual void leave(const NodeAddress&) {}
};

struct WalkOptions {
  /// T_level is walked; levels beyond the tree mean its last level.
  std::uint32_t level = static_cast<std::uint32_t>(-1);
  /// If set, nodes and pieces come in front-to-back order: whatever can hide a piece comes before
  /// it (Veenstra and Ahuja 1988, section 3, with convex pieces in place of cubes).
  std::optional<Viewpoint> viewpoint;
  /// Passes over the leaves, at the cost of the GREY nodes alone.
  bool inner_nodes_only = false;
};

/// Visits the pieces of T_level. O(nodes), each a few clips of a small polyhedron.
/// REQUIRES: a valid tree (validate.hpp) with at least one level.
void walk_pieces(const Octree& tree, const WalkOptions& options, PieceVisitor& visitor);

/// The same for one part of the tree. Parts do not depend on each other.
void walk_pieces(const Octree& tree, const WalkOptions& options, const Subtree& subtree,
                 PieceVisitor& visitor);

/// The parts below a GREY node above the last level looked at, in the order of the walk: those that
/// the options want and whose region may have an interior. What a caller who goes on with them does
/// not hear of the node itself are `enter`, `inner` and `leave`.
std::vector<Subtree> children_of(const Octree& tree, const WalkOptions& options,
                                 const Subtree& subtree);

}  // namespace spoctree
