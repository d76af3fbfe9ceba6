#include "client/rebuild/level_pieces.hpp"

#include <algorithm>
#include <utility>

#include "common/base/parallel.hpp"
#include "common/tree/pieces.hpp"

namespace spoctree {

namespace {

/// So many parts of the tree keep all cores busy.
constexpr std::size_t kParts = 128;

/// The pieces of a part of the tree.
struct Collected {
  struct Leaf {
    std::uint32_t level;
    std::uint32_t index;
    LeafPieces pieces;
  };
  std::vector<Leaf> leaves;
  std::vector<std::uint32_t> corner_counts;
  std::vector<Vec3> corners;
  std::vector<std::uint32_t> bounds;
};

class Collector : public PieceVisitor {
 public:
  Collector(const Octree& tree, Collected& collected) : tree_(tree), to_(collected) {}

  void piece(const NodeAddress& node, NodeKind kind, std::uint32_t part,
             const Polyhedron& piece) override {
    if (to_.leaves.empty() || to_.leaves.back().level != node.level ||
        to_.leaves.back().index != node.index) {
      to_.leaves.push_back({node.level, node.index, {}});
      to_.leaves.back().pieces.first_piece = static_cast<std::uint32_t>(to_.corner_counts.size());
      to_.leaves.back().pieces.first_bound = static_cast<std::uint32_t>(to_.bounds.size());
    }
    LeafPieces& leaf = to_.leaves.back().pieces;
    for (; leaf.piece_count <= part; ++leaf.piece_count) to_.corner_counts.push_back(0);
    const bool is_cube = std::all_of(piece.faces.begin(), piece.faces.end(),
                                     [](const auto& face) { return face.plane.is_wall(); });
    if (kind == NodeKind::Black && is_cube) {
      leaf.is_whole_cube = true;
      return;
    }
    to_.corner_counts.back() = static_cast<std::uint32_t>(piece.vertices.size());
    for (const PolyhedronVertex& vertex : piece.vertices) to_.corners.push_back(vertex.position);
    const bool has_expression = kind == NodeKind::Concave || kind == NodeKind::Vertex;
    const auto own = tree_.levels[node.level].planes_of(node.index);
    for (const Polyhedron::Face& face : piece.faces) {
      const std::uint32_t plane = face.plane.index();
      if (face.plane.is_wall()) continue;
      if (has_expression && std::find(own.begin(), own.end(), plane) != own.end()) continue;
      const auto first = to_.bounds.begin() + leaf.first_bound;
      if (std::find(first, to_.bounds.end(), plane) != to_.bounds.end()) continue;
      to_.bounds.push_back(plane);
      ++leaf.bound_count;
    }
  }

 private:
  const Octree& tree_;
  Collected& to_;
};

/// Parts of the tree that make up the whole, in the order of the walk.
std::vector<Subtree> divide(const Octree& tree, const WalkOptions& options) {
  const std::size_t last = std::min<std::size_t>(options.level, tree.levels.size() - 1);
  std::vector<Subtree> parts(1);
  for (std::size_t level = 0; level < last && parts.size() < kParts; ++level) {
    std::vector<Subtree> finer;
    for (Subtree& part : parts) {
      if (part.root.level == level && tree.levels[level].kinds[part.root.index] == NodeKind::Grey) {
        for (Subtree& child : children_of(tree, options, part)) finer.push_back(std::move(child));
      } else {
        finer.push_back(std::move(part));
      }
    }
    parts = std::move(finer);
  }
  return parts;
}

}  // namespace

LevelPieces::LevelPieces(const Octree& tree, std::uint32_t level)
    : level_(static_cast<std::uint32_t>(std::min<std::size_t>(level, tree.levels.size() - 1))) {
  WalkOptions options;
  options.level = level_;
  const std::vector<Subtree> parts = divide(tree, options);
  std::vector<Collected> collected(parts.size());
  parallel_for(parts.size(), [&](std::size_t i) {
    Collector collector(tree, collected[i]);
    walk_pieces(tree, options, parts[i], collector);
  });

  numbers_.resize(level_ + 1);
  for (std::uint32_t k = 0; k <= level_; ++k) numbers_[k].assign(tree.levels[k].size(), kNone);
  std::size_t leaf_count = 0, piece_count = 0, corner_count = 0, bound_count = 0;
  for (const Collected& part : collected) {
    leaf_count += part.leaves.size();
    piece_count += part.corner_counts.size();
    corner_count += part.corners.size();
    bound_count += part.bounds.size();
  }
  leaves_.reserve(leaf_count);
  corner_begin_.reserve(piece_count + 1);
  corners_.reserve(corner_count);
  bounds_.reserve(bound_count);
  corner_begin_.push_back(0);
  for (Collected& part : collected) {
    for (Collected::Leaf& leaf : part.leaves) {
      numbers_[leaf.level][leaf.index] = static_cast<std::uint32_t>(leaves_.size());
      leaf.pieces.first_piece += static_cast<std::uint32_t>(corner_begin_.size() - 1);
      leaf.pieces.first_bound += static_cast<std::uint32_t>(bounds_.size());
      leaves_.push_back(leaf.pieces);
    }
    for (const std::uint32_t count : part.corner_counts) {
      corner_begin_.push_back(corner_begin_.back() + count);
    }
    corners_.insert(corners_.end(), part.corners.begin(), part.corners.end());
    bounds_.insert(bounds_.end(), part.bounds.begin(), part.bounds.end());
    part = {};
  }
}

}  // namespace spoctree
