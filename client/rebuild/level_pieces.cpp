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

// What there can be too much of.
constexpr const char* kLeaves = "leaves with material";
constexpr const char* kCorners = "corners of pieces in a part of the tree";
constexpr const char* kBounds = "planes that bound leaves in a part of the tree";
constexpr const char* kTokens = "tokens of expressions in a part of the tree";

/// WHITE nodes are not visited.
std::size_t count_nodes(const Octree& tree, std::uint32_t first_level, std::uint32_t last_level) {
  std::size_t nodes = 0;
  for (std::uint32_t k = first_level; k <= last_level; ++k) {
    const Level& level = tree.levels[k];
    nodes += level.size() - level.count_kinds()[static_cast<std::size_t>(NodeKind::White)];
  }
  return nodes;
}

}  // namespace

/// Finds the pieces of some subtrees.
class LevelPieces::Collector : public PieceVisitor {
 public:
  /// A share of `per_node` is done with each node.
  Collector(const Octree& tree, const PieceLimits& limits, const ProgressShare& progress,
            double per_node)
      : tree_(tree),
        planes_(tree.plane_set()),
        limits_(limits),
        progress_(progress),
        per_node_(per_node) {}

  struct Found {
    std::vector<LeafPieces> leaves;
    Store store;
  };
  Found settled;
  Found frontier;
  struct Number {
    std::uint32_t level;
    std::uint32_t index;
  };
  std::vector<Number> settled_nodes;
  std::vector<NodeAddress> frontier_nodes;
  std::uint64_t visited = 0;

  bool enter(const NodeAddress& node, NodeKind kind, const Polyhedron& region) override {
    ++visited;
    progress_.add(per_node_);
    const Level& level = tree_.levels[node.level];
    if (kind == NodeKind::Vertex) {
      divide(node, region, level.planes_of(node.index), level.expression_of(node.index));
    } else if (kind == NodeKind::Concave) {
      const auto planes = level.planes_of(node.index);
      union_of(static_cast<std::uint32_t>(planes.size()), union_);
      divide(node, region, planes, union_);
    } else {
      return true;
    }
    return false;
  }

  void piece(const NodeAddress& node, NodeKind kind, std::uint32_t,
             const Polyhedron& piece) override {
    const bool is_frontier = kind == NodeKind::Grey;
    Found& to = is_frontier ? frontier : settled;
    LeafPieces& leaf = start_leaf(node, piece, to);
    leaf.is_frontier = is_frontier;
    leaf.is_whole_cube = kind == NodeKind::Black && leaf.bound_count == 0;
    if (!leaf.is_whole_cube) add_piece(leaf, piece, to.store);
    if (is_frontier) {
      frontier_nodes.push_back(node);
    } else {
      settled_nodes.push_back({node.level, node.index});
    }
  }

  void finish() {
    progress_.tell();
    for (Store* const store : {&settled.store, &frontier.store}) {
      store->corner_begin.shrink_to_fit();
      store->corners.shrink_to_fit();
      store->bounds.shrink_to_fit();
      store->tokens.shrink_to_fit();
    }
  }

 private:
  std::uint32_t size_of(const auto& items, const char* what) const {
    return small_count(items.size(), what, limits_.corners);
  }

  LeafPieces& start_leaf(const NodeAddress&, const Polyhedron& bounded, Found& to) const {
    Store& store = to.store;
    if (store.corner_begin.empty()) store.corner_begin.push_back(0);
    LeafPieces leaf;
    leaf.first_piece = static_cast<std::uint32_t>(store.corner_begin.size() - 1);
    leaf.first_bound = size_of(store.bounds, kBounds);
    leaf.first_token = size_of(store.tokens, kTokens);
    for (const Polyhedron::Face& face : bounded.faces) {
      if (!face.plane.is_wall()) store.bounds.push_back(face.plane.index());
    }
    leaf.bound_count = size_of(store.bounds, kBounds) - leaf.first_bound;
    small_count(to.leaves.size() + 1, kLeaves, limits_.leaves);
    to.leaves.push_back(leaf);
    return to.leaves.back();
  }

  void add_piece(LeafPieces& leaf, const Polyhedron& piece, Store& to) const {
    ++leaf.piece_count;
    // A piece has corners: there are fewer pieces than these.
    small_count(to.corners.size() + piece.vertices.size(), kCorners, limits_.corners);
    for (const PolyhedronVertex& vertex : piece.vertices) to.corners.push_back(vertex.position);
    to.corner_begin.push_back(static_cast<std::uint32_t>(to.corners.size()));
  }

  /// The expression, and the pieces of its in-cells, in preorder; splits that leave no interior on
  /// one side are passed over. A stack of its own instead of recursion: there are as many splits
  /// within each other as the node has planes.
  void divide(const NodeAddress& node, const Polyhedron& region,
              std::span<const std::uint32_t> planes, std::span<const std::uint32_t> expression) {
    LeafPieces& leaf = start_leaf(node, region, settled);
    settled_nodes.push_back({node.level, node.index});
    PlainVector<std::uint32_t>& tokens = settled.store.tokens;
    find_ends(expression, ends_);
    open_.clear();
    open_.push_back({0, region});
    while (!open_.empty()) {
      const std::uint32_t at = open_.back().token;
      std::swap(cell_, open_.back().cell);
      open_.pop_back();
      const std::uint32_t token = expression[at];
      if (token < kFirstPlaneToken) {
        tokens.push_back(token);
        if (token == kInToken) add_piece(leaf, cell_, settled.store);
        continue;
      }
      const PlaneRef plane = PlaneRef::of_table(planes[token - kFirstPlaneToken]);
      const auto parts = clipper_.split(cell_, plane, planes_, inside_, outside_);
      if (parts.inside && parts.outside) tokens.push_back(token);
      if (parts.outside) open_.push_back({ends_[at + 1], outside_});
      if (parts.inside) open_.push_back({at + 1, inside_});
    }
    leaf.token_count = size_of(tokens, kTokens) - leaf.first_token;
  }

  struct Open {
    std::uint32_t token;
    Polyhedron cell;
  };

  const Octree& tree_;
  const PlaneSet planes_;
  const PieceLimits limits_;
  ProgressCounter progress_;
  const double per_node_;
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
  const std::size_t count = frontier_nodes_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const NodeAddress& node = frontier_nodes_[k];
    const auto planes = bounds(frontier_.leaves[k]);
    const std::uint32_t first_child = tree.levels[node.level].first_child[node.index];
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      groups[k * kParts / count].push_back(
          {node.child(first_child, octant), {planes.begin(), planes.end()}});
    }
  }
  return groups;
}

/// Leaves get their numbers in the order of the parts.
void LevelPieces::gather(std::vector<Collector>& found) {
  const auto begin_of = [&](Leaves& to, Collector::Found Collector::*of) {
    std::vector<std::size_t> begin{to.leaves.size()};
    for (const Collector& part : found) begin.push_back(begin.back() + (part.*of).leaves.size());
    small_count(begin.back(), kLeaves, limits_.leaves);
    to.leaves.resize(begin.back());
    return begin;
  };
  const auto settled_begin = begin_of(settled_, &Collector::settled);
  const auto frontier_begin = begin_of(frontier_, &Collector::frontier);
  std::vector<std::size_t> settled_store(found.size()), frontier_store(found.size());
  const auto move_store = [](Collector::Found& part, Leaves& to) {
    if (!part.leaves.empty()) to.stores.push_back(std::move(part.store));
    return to.stores.size() - 1;
  };
  for (std::size_t i = 0; i < found.size(); ++i) {
    settled_store[i] = move_store(found[i].settled, settled_);
    frontier_store[i] = move_store(found[i].frontier, frontier_);
    nodes_visited_ += found[i].visited;
  }
  frontier_nodes_.resize(frontier_.leaves.size());
  parallel_for(found.size(), [&](std::size_t i) {
    Collector& part = found[i];
    const auto put = [&](const auto& nodes, std::vector<LeafPieces>& leaves, std::size_t store,
                         std::size_t first, Leaves& to, std::uint32_t flag) {
      for (std::size_t k = 0; k < leaves.size(); ++k) {
        numbers_[nodes[k].level][nodes[k].index] = static_cast<std::uint32_t>(first + k) | flag;
        leaves[k].store = static_cast<std::uint16_t>(store);
        to.leaves[first + k] = leaves[k];
      }
    };
    put(part.settled_nodes, part.settled.leaves, settled_store[i], settled_begin[i], settled_, 0);
    put(part.frontier_nodes, part.frontier.leaves, frontier_store[i], frontier_begin[i], frontier_,
        kInFrontier);
    std::copy(part.frontier_nodes.begin(), part.frontier_nodes.end(),
              frontier_nodes_.begin() + static_cast<std::ptrdiff_t>(frontier_begin[i]));
  });
}

void LevelPieces::go_on_to(const Octree& tree, std::uint32_t level, const ProgressShare& progress) {
  level = static_cast<std::uint32_t>(std::min<std::size_t>(level, tree.levels.size() - 1));
  const bool is_next = !numbers_.empty() && level == level_ + 1;
  const auto groups = is_next ? divide_frontier(tree) : divide(tree, level);
  if (!is_next) *this = LevelPieces(limits_);
  WalkOptions options;
  options.level = level;
  const double per_node = per_item(count_nodes(tree, is_next ? level : 0, level));
  std::vector<Collector> found;
  found.reserve(groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i)
    found.emplace_back(tree, limits_, progress, per_node);
  parallel_for(groups.size(), [&](std::size_t i) {
    for (const Subtree& subtree : groups[i]) walk_pieces(tree, options, subtree, found[i]);
    found[i].finish();
  });
  for (const NodeAddress& node : frontier_nodes_) numbers_[node.level][node.index] = kNone;
  frontier_ = {};
  level_ = level;
  while (numbers_.size() <= level) {
    numbers_.emplace_back(tree.levels[numbers_.size()].size(), kNone);
  }
  gather(found);
}

}  // namespace spoctree
