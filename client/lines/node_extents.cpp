#include "client/lines/node_extents.hpp"

#include <glm/common.hpp>
#include <limits>

namespace spoctree {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr NodeBox kEmpty{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

class BoxFinder {
 public:
  BoxFinder(const Octree& tree, const LevelPieces& pieces, std::span<const Crease> creases,
            const CreaseParts& parts, const ProgressShare& progress,
            std::vector<std::vector<NodeBox>>& boxes)
      : tree_(tree),
        pieces_(pieces),
        creases_(creases),
        parts_(parts),
        progress_(progress),
        boxes_(boxes) {
    std::size_t nodes = 0;
    for (const auto& level : boxes) nodes += level.size();
    per_node_ = per_item(nodes);
  }

  void finish() { progress_.tell(); }

  const NodeBox& visit(const NodeAddress& node) {
    const Level& level = tree_.levels[node.level];
    NodeBox& box = boxes_[node.level][node.index];
    box = kEmpty;
    progress_.add(per_node_);
    if (level.kinds[node.index] == NodeKind::Grey && node.level < pieces_.level()) {
      for (std::uint32_t octant = 0; octant < 8; ++octant) {
        const NodeBox& child = visit(node.child(level.first_child[node.index], octant));
        box.lower = glm::min(box.lower, child.lower);
        box.upper = glm::max(box.upper, child.upper);
      }
    } else {
      find_leaf(node, box);
    }
    return box;
  }

 private:
  void find_leaf(const NodeAddress& node, NodeBox& box) const {
    const auto add = [&](Vec3 point) {
      box.lower = glm::min(box.lower, point);
      box.upper = glm::max(box.upper, point);
    };
    if (const LeafPieces* const leaf = pieces_.find(node)) {
      if (leaf->is_whole_cube) {
        for (const std::uint32_t far : {0u, node.size()}) {
          Vec3 corner;
          for (int axis = 0; axis < 3; ++axis) {
            corner[axis] = wall_coordinate(tree_.universe.half_side, node.lower[axis] + far);
          }
          add(corner);
        }
      }
      for (std::uint32_t part = 0; part < leaf->piece_count; ++part) {
        for (const Vec3 corner : pieces_.corners(*leaf, part)) add(corner);
      }
    }
    for (const CreasePart& part : parts_.of(node)) {
      const Crease& crease = creases_[part.crease];
      add(crease.a + part.interval.begin * (crease.b - crease.a));
      add(crease.a + part.interval.end * (crease.b - crease.a));
    }
  }

  const Octree& tree_;
  const LevelPieces& pieces_;
  const std::span<const Crease> creases_;
  const CreaseParts& parts_;
  ProgressCounter progress_;
  double per_node_ = 0;
  std::vector<std::vector<NodeBox>>& boxes_;
};

}  // namespace

NodeExtents::NodeExtents(const Octree& tree, const LevelPieces& pieces,
                         std::span<const Crease> creases, const CreaseParts& parts,
                         const ProgressShare& progress) {
  boxes_.resize(pieces.level() + 1);
  for (std::uint32_t k = 0; k <= pieces.level(); ++k) boxes_[k].resize(tree.levels[k].size());
  BoxFinder finder(tree, pieces, creases, parts, progress, boxes_);
  finder.visit({});
  finder.finish();
}

}  // namespace spoctree
