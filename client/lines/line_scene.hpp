// A level, prepared to be drawn from any side: what no view changes.
#pragma once

#include "client/lines/crease.hpp"
#include "client/lines/crease_parts.hpp"
#include "client/lines/node_extents.hpp"
#include "client/rebuild/level_pieces.hpp"
#include "client/rebuild/surface.hpp"

namespace spoctree {

/// The convex pieces of T_level, its creases, and which of these touch which leaf.
class LineScene {
 public:
  /// `surface` is rebuild_surface(tree, level); levels beyond the tree mean its last level. Time
  /// and memory O(nodes + creases), in parallel. REQUIRES: a valid tree (validate.hpp), which
  /// outlives the scene. Throws BadInput if there is more of anything than can be counted (see
  /// PieceLimits, CreaseParts), or what `progress` throws.
  LineScene(const Octree& tree, const Surface& surface,
            std::uint32_t level = static_cast<std::uint32_t>(-1),
            const ProgressShare& progress = {});

  /// The same of another level, of which the tree has got more nodes by now. If it is the next one,
  /// the pieces of leaves are kept, whose finding takes most of the time. Throws as above; the
  /// scene can only be destroyed then.
  void go_on_to(const Surface& surface, std::uint32_t level, const ProgressShare& progress = {});

  const Octree& tree() const { return tree_; }
  std::uint32_t level() const { return pieces_.level(); }
  /// The diagonal of the universe cube, in universe units.
  double diagonal() const { return diagonal_; }
  const Creases& creases() const { return creases_; }
  const LevelPieces& pieces() const { return pieces_; }
  const CreaseParts& parts() const { return parts_; }
  const NodeExtents& extents() const { return extents_; }

 private:
  const Octree& tree_;
  double diagonal_;
  Creases creases_;
  LevelPieces pieces_;
  CreaseParts parts_;
  NodeExtents extents_;
};

}  // namespace spoctree
