// How much of its cube the content of each node takes up: what no view changes.
#pragma once

#include <cstdint>
#include <vector>

#include "client/lines/crease_parts.hpp"
#include "client/rebuild/level_pieces.hpp"

namespace spoctree {

/// Universe coordinates.
struct NodeBox {
  Vec3 lower{0.0};
  Vec3 upper{0.0};
};

/// Boxes around the pieces and the parts of creases in each node and below it.
class NodeExtents {
 public:
  /// O(nodes + corners of pieces + parts). Throws what `progress` throws.
  NodeExtents(const Octree& tree, const LevelPieces& pieces, std::span<const Crease> creases,
              const CreaseParts& parts, const ProgressShare& progress = {});

  /// REQUIRES: not empty.
  const NodeBox& of(const NodeAddress& node) const { return boxes_[node.level][node.index]; }
  bool is_empty(const NodeAddress& node) const {
    return boxes_[node.level][node.index].lower.x > boxes_[node.level][node.index].upper.x;
  }

 private:
  std::vector<std::vector<NodeBox>> boxes_;  // by level and index
};

}  // namespace spoctree
