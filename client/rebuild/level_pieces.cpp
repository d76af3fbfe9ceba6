#include "client/rebuild/level_pieces.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/base/parallel.hpp"
#include "common/geometry/polyhedron_clipper.hpp"
#include "common/tree/expression.hpp"
#include "common/tree/pieces.hpp"

namespace spoctree {

namespace {

/// So many parts of the tree keep all cores busy.
constexpr std::size_t kParts = 128;

std::uint32_t size_of(const auto& items) { return static_cast<std::uint32_t>(items.size()); }

}  // namespace

/// Finds the pieces of some subtrees.
class LevelPieces::Collector : public PieceVisitor {
 public:
  explicit Collector(const Octree& tree) : tree_(tree), planes_(tree.plane_set()) {}

  Store settled;
  Store frontier;
  std::uint64_t visited = 0;

  bool enter(const NodeAddress& node, NodeKind kind, const Polyhedron& region) override {
    ++visited;
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
    const bool is_frontier = kind == NodeKind::Grey;
    Store& to = is_frontier ? frontier : settled;
    LeafPieces& leaf = start_leaf(node, piece, to);
    leaf.is_frontier = is_frontier;
    leaf.is_whole_cube = kind == NodeKind::Black && leaf.bound_count == 0;
    if (!leaf.is_whole_cube) add_piece(leaf, piece, to);
  }

 private:
  static LeafPieces& start_leaf(const NodeAddress& node, const Polyhedron& bounded, Store& to) {
    LeafPieces leaf;
    leaf.first_piece = size_of(to.corner_begin) - 1;
    leaf.first_bound = size_of(to.bounds);
    leaf.first_token = size_of(to.tokens);
    for (const Polyhedron::Face& face : bounded.faces) {
      if (!face.plane.is_wall()) to.bounds.push_back(face.plane.index());
    }
    leaf.bound_count = size_of(to.bounds) - leaf.first_bound;
    to.leaves.push_back(leaf);
    to.nodes.push_back(node);
    return to.leaves.back();
  }

  static void add_piece(LeafPieces& leaf, const Polyhedron& piece, Store& to) {
    ++leaf.piece_count;
    for (const PolyhedronVertex& vertex : piece.vertices) to.corners.push_back(vertex.position);
    to.corner_begin.push_back(size_of(to.corners));
  }

  /// The expression, and the pieces of its in-cells, in preorder; splits that leave no interior on
  /// one side are passed over. A stack of its own instead of recursion: there are as many splits
  /// within each other as the node has planes.
  void divide(const NodeAddress& node, const Polyhedron& region,
              std::span<const std::uint32_t> planes, std::span<const std::uint32_t> expression) {
    LeafPieces& leaf = start_leaf(node, region, settled);
    find_ends(expression, ends_);
    open_.clear();
    open_.push_back({0, region});
    while (!open_.empty()) {
      const std::uint32_t at = open_.back().token;
      std::swap(cell_, open_.back().cell);
      open_.pop_back();
      const std::uint32_t token = expression[at];
      if (token < kFirstPlaneToken) {
        settled.tokens.push_back(token);
        if (token == kInToken) add_piece(leaf, cell_, settled);
        continue;
      }
      const PlaneRef plane = PlaneRef::of_table(planes[token - kFirstPlaneToken]);
      const auto parts = clipper_.split(cell_, plane, planes_, inside_, outside_);
      if (parts.inside && parts.outside) settled.tokens.push_back(token);
      if (parts.outside) open_.push_back({ends_[at + 1], outside_});
      if (parts.inside) open_.push_back({at + 1, inside_});
    }
    leaf.token_count = size_of(settled.tokens) - leaf.first_token;
  }

  struct Open {
    std::uint32_t token;
    Polyhedron cell;
  };

  const Octree& tree_;
  const PlaneSet planes_;
  PolyhedronClipper clipper_;
  Polyhedron cell_, inside_, outside_;
  std::vector<Open> open_;
  std::vector<std::uint32_t> union_, ends_;
};

/// Parts of the tree that make up the whole, in the order of the walk, one by one.
std::vector<std::vector<Subtree>> LevelPieces::divide(const Octree& tree, std::uint32_t level) {
  WalkOptions options;
  options.level = level;
  std::vector<Subtree> parts(1);
  for (std::uint32_t k = 0; k < level && parts.size() < kParts; ++k) {
    std::vector<Subtree> finer;
    for (Subtree& part : parts) {
      if (part.root.level == k && tree.levels[k].kinds[part.root.index] == NodeKind::Grey) {
        for (Subtree& child : children_of(tree, options, part)) finer.push_back(std::move(child));
      } else {
        finer.push_back(std::move(part));
      }
    }
    parts = std::move(finer);
  }
  std::vector<std::vector<Subtree>> groups(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) groups[i].push_back(std::move(parts[i]));
  return groups;
}

/// The children of the GREY nodes, in groups. What bounds a node's piece is all that may cut them.
std::vector<std::vector<Subtree>> LevelPieces::divide_frontier(const Octree& tree) const {
  std::vector<std::vector<Subtree>> groups(kParts);
  const std::size_t count = frontier_.nodes.size();
  for (std::size_t k = 0; k < count; ++k) {
    const NodeAddress& node = frontier_.nodes[k];
    const auto planes = bounds(frontier_.leaves[k]);
    const std::uint32_t first_child = tree.levels[node.level].first_child[node.index];
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      groups[k * kParts / count].push_back(
          {node.child(first_child, octant), {planes.begin(), planes.end()}});
    }
  }
  return groups;
}

void LevelPieces::append(const Store& part, Store& store, std::uint32_t flag) {
  const std::uint32_t first_piece = size_of(store.corner_begin) - 1;
  const std::uint32_t first_bound = size_of(store.bounds);
  const std::uint32_t first_token = size_of(store.tokens);
  const std::uint32_t first_corner = size_of(store.corners);
  for (std::size_t k = 0; k < part.leaves.size(); ++k) {
    numbers_[part.nodes[k].level][part.nodes[k].index] = size_of(store.leaves) | flag;
    LeafPieces leaf = part.leaves[k];
    leaf.first_piece += first_piece;
    leaf.first_bound += first_bound;
    leaf.first_token += first_token;
    store.leaves.push_back(leaf);
  }
  for (std::size_t k = 1; k < part.corner_begin.size(); ++k) {
    store.corner_begin.push_back(first_corner + part.corner_begin[k]);
  }
  store.corners.insert(store.corners.end(), part.corners.begin(), part.corners.end());
  store.bounds.insert(store.bounds.end(), part.bounds.begin(), part.bounds.end());
  store.tokens.insert(store.tokens.end(), part.tokens.begin(), part.tokens.end());
  if (flag != 0) store.nodes.insert(store.nodes.end(), part.nodes.begin(), part.nodes.end());
}

void LevelPieces::go_on_to(const Octree& tree, std::uint32_t level) {
  level = static_cast<std::uint32_t>(std::min<std::size_t>(level, tree.levels.size() - 1));
  const bool is_next = !numbers_.empty() && level == level_ + 1;
  if (!is_next) *this = LevelPieces();
  const auto groups = is_next ? divide_frontier(tree) : divide(tree, level);
  WalkOptions options;
  options.level = level;
  std::vector<std::optional<Collector>> found(groups.size());
  parallel_for(groups.size(), [&](std::size_t i) {
    found[i].emplace(tree);
    for (const Subtree& subtree : groups[i]) walk_pieces(tree, options, subtree, *found[i]);
  });
  for (const NodeAddress& node : frontier_.nodes) numbers_[node.level][node.index] = kNone;
  frontier_ = {};
  level_ = level;
  while (numbers_.size() <= level) {
    numbers_.emplace_back(tree.levels[numbers_.size()].size(), kNone);
  }
  for (auto& part : found) {
    append(part->settled, settled_, 0);
    append(part->frontier, frontier_, kInFrontier);
    nodes_visited_ += part->visited;
    part.reset();
  }
}

}  // namespace spoctree
