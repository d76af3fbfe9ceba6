#include "client/rebuild/level_pieces.hpp"

#include <algorithm>
#include <utility>

#include "common/base/parallel.hpp"
#include "common/geometry/polyhedron_clipper.hpp"
#include "common/tree/expression.hpp"
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
  std::vector<std::uint32_t> tokens;
};

std::uint32_t size_of(const auto& items) { return static_cast<std::uint32_t>(items.size()); }

class Collector : public PieceVisitor {
 public:
  Collector(const Octree& tree, Collected& collected)
      : tree_(tree), planes_(tree.plane_set()), to_(collected) {}

  bool enter(const NodeAddress& node, NodeKind kind, const Polyhedron& region) override {
    const Level& level = tree_.levels[node.level];
    if (kind == NodeKind::Vertex) {
      divide(node, region, level.planes_of(node.index), level.expression_of(node.index));
    } else if (kind == NodeKind::Concave) {
      const auto planes = level.planes_of(node.index);
      union_of(size_of(planes), union_);
      divide(node, region, planes, union_);
    } else {
      return true;
    }
    return false;
  }

  void piece(const NodeAddress& node, NodeKind kind, std::uint32_t,
             const Polyhedron& piece) override {
    LeafPieces& leaf = start_leaf(node, piece);
    leaf.is_whole_cube = kind == NodeKind::Black && leaf.bound_count == 0;
    if (!leaf.is_whole_cube) add_piece(leaf, piece);
  }

 private:
  LeafPieces& start_leaf(const NodeAddress& node, const Polyhedron& bounded) {
    LeafPieces leaf;
    leaf.first_piece = size_of(to_.corner_counts);
    leaf.first_bound = size_of(to_.bounds);
    leaf.first_token = size_of(to_.tokens);
    for (const Polyhedron::Face& face : bounded.faces) {
      if (!face.plane.is_wall()) to_.bounds.push_back(face.plane.index());
    }
    leaf.bound_count = size_of(to_.bounds) - leaf.first_bound;
    to_.leaves.push_back({node.level, node.index, leaf});
    return to_.leaves.back().pieces;
  }

  void add_piece(LeafPieces& leaf, const Polyhedron& piece) {
    ++leaf.piece_count;
    to_.corner_counts.push_back(size_of(piece.vertices));
    for (const PolyhedronVertex& vertex : piece.vertices) to_.corners.push_back(vertex.position);
  }

  /// The expression, and the pieces of its in-cells, in preorder; splits that leave no interior on
  /// one side are passed over. A stack of its own instead of recursion: there are as many splits
  /// within each other as the node has planes.
  void divide(const NodeAddress& node, const Polyhedron& region,
              std::span<const std::uint32_t> planes, std::span<const std::uint32_t> expression) {
    LeafPieces& leaf = start_leaf(node, region);
    find_ends(expression, ends_);
    open_.clear();
    open_.push_back({0, region});
    while (!open_.empty()) {
      const std::uint32_t at = open_.back().token;
      std::swap(cell_, open_.back().cell);
      open_.pop_back();
      const std::uint32_t token = expression[at];
      if (token < kFirstPlaneToken) {
        to_.tokens.push_back(token);
        if (token == kInToken) add_piece(leaf, cell_);
        continue;
      }
      const PlaneRef plane = PlaneRef::of_table(planes[token - kFirstPlaneToken]);
      const auto parts = clipper_.split(cell_, plane, planes_, inside_, outside_);
      if (parts.inside && parts.outside) to_.tokens.push_back(token);
      if (parts.outside) open_.push_back({ends_[at + 1], outside_});
      if (parts.inside) open_.push_back({at + 1, inside_});
    }
    leaf.token_count = size_of(to_.tokens) - leaf.first_token;
  }

  struct Open {
    std::uint32_t token;
    Polyhedron cell;
  };

  const Octree& tree_;
  const PlaneSet planes_;
  Collected& to_;
  PolyhedronClipper clipper_;
  Polyhedron cell_, inside_, outside_;
  std::vector<Open> open_;
  std::vector<std::uint32_t> union_, ends_;
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
  std::size_t leaf_count = 0, piece_count = 0, corner_count = 0, bound_count = 0, token_count = 0;
  for (const Collected& part : collected) {
    leaf_count += part.leaves.size();
    piece_count += part.corner_counts.size();
    corner_count += part.corners.size();
    bound_count += part.bounds.size();
    token_count += part.tokens.size();
  }
  leaves_.reserve(leaf_count);
  corner_begin_.reserve(piece_count + 1);
  corners_.reserve(corner_count);
  bounds_.reserve(bound_count);
  tokens_.reserve(token_count);
  corner_begin_.push_back(0);
  for (Collected& part : collected) {
    for (Collected::Leaf& leaf : part.leaves) {
      numbers_[leaf.level][leaf.index] = size_of(leaves_);
      leaf.pieces.first_piece += size_of(corner_begin_) - 1;
      leaf.pieces.first_bound += size_of(bounds_);
      leaf.pieces.first_token += size_of(tokens_);
      leaves_.push_back(leaf.pieces);
    }
    for (const std::uint32_t count : part.corner_counts) {
      corner_begin_.push_back(corner_begin_.back() + count);
    }
    corners_.insert(corners_.end(), part.corners.begin(), part.corners.end());
    bounds_.insert(bounds_.end(), part.bounds.begin(), part.bounds.end());
    tokens_.insert(tokens_.end(), part.tokens.begin(), part.tokens.end());
    part = {};
  }
}

}  // namespace spoctree
