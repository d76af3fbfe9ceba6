#include "common/tree/pieces.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "common/geometry/predicates.hpp"
#include "common/tree/cell_regions.hpp"
#include "common/tree/expression.hpp"

namespace spoctree {

namespace {

class Walker {
 public:
  Walker(const Octree& tree, const WalkOptions& options, PieceVisitor* visitor)
      : tree_(tree),
        last_level_(std::min<std::size_t>(options.level, tree.levels.size() - 1)),
        viewpoint_(options.viewpoint),
        inner_nodes_only_(options.inner_nodes_only),
        visitor_(visitor),
        regions_(tree) {}

  void walk(const Subtree& subtree) {
    const NodeAddress& root = subtree.root;
    if (!is_wanted(tree_.levels[root.level].kinds[root.index])) return;
    Polyhedron& region = scratch();
    if (regions_.make(root, subtree.planes, nullptr, region)) visit(root, region);
    release();
  }

  std::vector<Subtree> children_of(const Subtree& subtree) {
    const NodeAddress& root = subtree.root;
    const Level& level = tree_.levels[root.level];
    std::vector<Subtree> children;
    Polyhedron region;
    if (!regions_.make(root, subtree.planes, nullptr, region) ||
        !regions_.clip(region, level.planes_of(root.index))) {
      return children;
    }
    for_each_child(root, level.first_child[root.index], region, [&](const NodeAddress& child) {
      children.push_back({child, cutting_});
    });
    return children;
  }

 private:
  // Polyhedra in use, as a stack whose storage is kept.
  Polyhedron& scratch() {
    if (used_ == storage_.size()) storage_.emplace_back();
    return storage_[used_++];
  }
  void release() { --used_; }

  /// Exact: one wrong order next to a viewer in a plane could hide anything behind it.
  bool viewer_is_outside(PlaneRef ref) const {
    const Plane plane = regions_.planes()[ref];
    return side_of_any_point({plane.normal, plane.offset * viewpoint_->w}, viewpoint_->xyz) > 0;
  }

  /// `region` may be clipped further: the caller is done with it.
  void visit(const NodeAddress& address, Polyhedron& region) {
    const Level& level = tree_.levels[address.level];
    const NodeKind kind = level.kinds[address.index];
    if (!visitor_->enter(address, kind, region)) return;
    const auto planes = level.planes_of(address.index);
    part_ = 0;
    switch (kind) {
      case NodeKind::White:
        break;
      case NodeKind::Black:
        emit(address, kind, region);
        break;
      case NodeKind::Convex:
        if (regions_.clip(region, planes)) emit(address, kind, region);
        break;
      case NodeKind::Concave:
        union_of(static_cast<std::uint32_t>(planes.size()), union_);
        visit_expression(address, kind, region, planes, union_);
        break;
      case NodeKind::Vertex:
        visit_expression(address, kind, region, planes, level.expression_of(address.index));
        break;
      case NodeKind::Grey:
        if (!regions_.clip(region, planes)) break;
        if (address.level == last_level_) {
          emit(address, kind, region);
        } else {
          visitor_->inner(address, region);
          for_each_child(address, level.first_child[address.index], region,
                         [&](const NodeAddress& child) {
                           Polyhedron& part = scratch();
                           if (regions_.make(child, cutting_, &region, part)) visit(child, part);
                           release();
                         });
        }
        break;
    }
    visitor_->leave(address);
  }

  void emit(const NodeAddress& address, NodeKind kind, const Polyhedron& piece) {
    visitor_->piece(address, kind, part_++, piece);
  }

  bool is_wanted(NodeKind kind) const {
    return inner_nodes_only_ ? kind == NodeKind::Grey : kind != NodeKind::White;
  }

  /// Calls visit_child(address), with `cutting_` the planes that may cut its cube, for the wanted
  /// children that are not certainly outside `region`: near halves first, by z, then y, then x.
  template <class VisitChild>
  void for_each_child(const NodeAddress& parent, std::uint32_t first_child,
                      const Polyhedron& region, VisitChild&& visit_child) {
    std::uint32_t nearest = 0;
    for (int axis = 0; viewpoint_ && axis < 3; ++axis) {
      const PlaneRef middle = PlaneRef::of_wall(axis, parent.lower[axis] + parent.size() / 2);
      if (viewer_is_outside(middle)) nearest |= 1u << static_cast<unsigned>(axis);
    }
    const auto frame = regions_.open(&region);
    for (std::uint32_t i = 0; i < 8; ++i) {
      const NodeAddress child = parent.child(first_child, i ^ nearest);
      if (!is_wanted(tree_.levels[child.level].kinds[child.index])) continue;
      if (regions_.select(frame, child, cutting_)) visit_child(child);
    }
    regions_.close(frame);
  }

  /// The in-cells of an expression, by splitting the region. A stack of its own instead of
  /// recursion: there are as many splits within each other as the node has planes.
  void visit_expression(const NodeAddress& address, NodeKind kind, Polyhedron& region,
                        std::span<const std::uint32_t> planes,
                        std::span<const std::uint32_t> expression) {
    find_ends(expression, ends_);
    // The polyhedra of the parts that are still to be visited are the last ones in use, and the
    // nearest of them is on top.
    const std::size_t bottom = open_parts_.size();
    std::swap(scratch(), region);
    open_parts_.push_back(0);
    while (open_parts_.size() > bottom) {
      Polyhedron& part = storage_[used_ - 1];
      const std::uint32_t at = open_parts_.back();
      const std::uint32_t token = expression[at];
      if (token < kFirstPlaneToken) {
        if (token == kInToken) emit(address, kind, part);
        open_parts_.pop_back();
        release();
        continue;
      }
      PlaneRef near_side = PlaneRef::of_table(planes[token - kFirstPlaneToken]);
      std::uint32_t near = at + 1;
      std::uint32_t far = ends_[at + 1];
      if (viewpoint_ && viewer_is_outside(near_side)) {
        std::swap(near, far);
        near_side = near_side.flipped();
      }
      if (expression[near] == kOutToken || expression[far] == kOutToken) {
        // One half will do.
        const bool is_near = expression[far] == kOutToken;
        open_parts_.back() = is_near ? near : far;
        const PlaneRef side = is_near ? near_side : near_side.flipped();
        if (regions_.clipper().clip(part, side, regions_.planes()) == ClipResult::Empty) {
          open_parts_.pop_back();
          release();
        }
        continue;
      }
      Polyhedron& near_part = scratch();
      const auto parts =
          regions_.clipper().split(part, near_side, regions_.planes(), near_part, far_part_);
      if (parts.outside) {
        std::swap(part, far_part_);
        open_parts_.back() = far;
      } else {
        std::swap(part, near_part);
        open_parts_.back() = near;
      }
      if (parts.inside && parts.outside) {
        open_parts_.push_back(near);
      } else {
        release();
      }
    }
  }

  const Octree& tree_;
  const std::size_t last_level_;
  const std::optional<Viewpoint> viewpoint_;
  const bool inner_nodes_only_;
  PieceVisitor* const visitor_;
  CellRegions regions_;
  std::vector<std::uint32_t> cutting_;
  std::deque<Polyhedron> storage_;  // a deque: references stay valid while it grows
  std::size_t used_ = 0;
  Polyhedron far_part_;                    // of the split at hand
  std::vector<std::uint32_t> open_parts_;  // where their expressions go on
  std::vector<std::uint32_t> ends_;        // of the expression at hand
  std::vector<std::uint32_t> union_;
  std::uint32_t part_ = 0;
};

}  // namespace

void walk_pieces(const Octree& tree, const WalkOptions& options, PieceVisitor& visitor) {
  walk_pieces(tree, options, Subtree{}, visitor);
}

void walk_pieces(const Octree& tree, const WalkOptions& options, const Subtree& subtree,
                 PieceVisitor& visitor) {
  Walker(tree, options, &visitor).walk(subtree);
}

std::vector<Subtree> children_of(const Octree& tree, const WalkOptions& options,
                                 const Subtree& subtree) {
  return Walker(tree, options, nullptr).children_of(subtree);
}

}  // namespace spoctree
