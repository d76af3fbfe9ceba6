#include "common/tree/pieces.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "common/geometry/predicates.hpp"
#include "common/tree/expression.hpp"

namespace spoctree {

NodeAddress NodeAddress::child(std::uint32_t first_child, std::uint32_t octant) const {
  NodeAddress address{level + 1, first_child + octant, {lower[0], lower[1], lower[2]}};
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    if ((octant >> axis) & 1) address.lower[axis] += address.size();
  }
  return address;
}

namespace {

class Walker {
 public:
  Walker(const Octree& tree, const WalkOptions& options, PieceVisitor& visitor)
      : tree_(tree),
        planes_(tree.plane_set()),
        last_level_(std::min<std::size_t>(options.level, tree.levels.size() - 1)),
        viewpoint_(options.viewpoint),
        inner_nodes_only_(options.inner_nodes_only),
        visitor_(visitor) {}

  void walk() {
    const NodeAddress root;
    if (!is_wanted(tree_.levels[0].kinds[0])) return;
    Polyhedron& region = scratch();
    region = make_cell(root.lower, root.size(), planes_);
    visit(root, region);
    release();
  }

 private:
  // Polyhedra in use, as a stack whose storage is kept.
  Polyhedron& scratch() {
    if (used_ == storage_.size()) storage_.emplace_back();
    return storage_[used_++];
  }
  void release() { --used_; }

  bool clip(Polyhedron& polyhedron, PlaneRef plane) {
    return clipper_.clip(polyhedron, plane, planes_) != ClipResult::Empty;
  }

  /// Exact: one wrong order next to a viewer in a plane could hide anything behind it.
  bool viewer_is_outside(PlaneRef ref) const {
    const Plane plane = planes_[ref];
    return side_of_any_point({plane.normal, plane.offset * viewpoint_->w}, viewpoint_->xyz) > 0;
  }

  /// `region` may be clipped further: the caller is done with it.
  void visit(const NodeAddress& address, Polyhedron& region) {
    const Level& level = tree_.levels[address.level];
    const NodeKind kind = level.kinds[address.index];
    if (!visitor_.enter(address, kind, region)) return;
    const auto planes = level.planes_of(address.index);
    part_ = 0;
    switch (kind) {
      case NodeKind::White:
        break;
      case NodeKind::Black:
        emit(address, kind, region);
        break;
      case NodeKind::Convex:
        if (clip_all(region, planes)) emit(address, kind, region);
        break;
      case NodeKind::Concave:
        visit_expression(address, kind, region, planes,
                         union_of(static_cast<std::uint32_t>(planes.size())).data());
        break;
      case NodeKind::Vertex:
        visit_expression(address, kind, region, planes, level.expression_of(address.index).data());
        break;
      case NodeKind::Grey:
        if (!clip_all(region, planes)) break;
        if (address.level == last_level_) {
          emit(address, kind, region);
        } else {
          visitor_.inner(address, region);
          visit_children(address, level.first_child[address.index], region, 2, 0);
        }
        break;
    }
    visitor_.leave(address);
  }

  void emit(const NodeAddress& address, NodeKind kind, const Polyhedron& piece) {
    visitor_.piece(address, kind, part_++, piece);
  }

  bool clip_all(Polyhedron& region, std::span<const std::uint32_t> planes) {
    return std::all_of(planes.begin(), planes.end(), [&](std::uint32_t plane) {
      return clip(region, PlaneRef::of_table(plane));
    });
  }

  bool is_wanted(NodeKind kind) const {
    return inner_nodes_only_ ? kind == NodeKind::Grey : kind != NodeKind::White;
  }

  /// Splits by the middle walls of z, then y, then x, near halves first. `octant` has the bits of
  /// the axes split so far. `region` may be clipped further.
  void visit_children(const NodeAddress& parent, std::uint32_t first_child, Polyhedron& region,
                      int axis, std::uint32_t octant) {
    if (axis < 0) {
      visit(parent.child(first_child, octant), region);
      return;
    }
    const std::uint32_t bit = 1u << static_cast<unsigned>(axis);
    const auto kinds = tree_.levels[parent.level + 1].kinds.begin() + first_child;
    const PlaneRef middle = PlaneRef::of_wall(axis, parent.lower[axis] + parent.size() / 2);
    const std::uint32_t near = viewpoint_ && viewer_is_outside(middle) ? 1 : 0;
    const auto is_half_wanted = [&](std::uint32_t half) {
      const auto first = kinds + (octant | half * bit);
      return std::any_of(first, first + bit, [&](NodeKind kind) { return is_wanted(kind); });
    };
    const bool wants_near = is_half_wanted(near);
    const bool wants_far = is_half_wanted(1 - near);
    const PlaneRef near_side = near == 1 ? middle.flipped() : middle;
    const auto visit_half = [&](std::uint32_t half, Polyhedron& part) {
      visit_children(parent, first_child, part, axis - 1, octant | half * bit);
    };
    if (wants_near && wants_far) {
      Polyhedron& near_part = scratch();
      Polyhedron& far_part = scratch();
      const auto parts = clipper_.split(region, near_side, planes_, near_part, far_part);
      if (parts.inside) visit_half(near, near_part);
      if (parts.outside) visit_half(1 - near, far_part);
      release();
      release();
    } else if (wants_near) {
      if (clip(region, near_side)) visit_half(near, region);
    } else if (wants_far) {
      if (clip(region, near_side.flipped())) visit_half(1 - near, region);
    }
  }

  /// The in-cells of an expression, by splitting the region. A stack of its own instead of
  /// recursion: there are as many splits within each other as the node has planes.
  void visit_expression(const NodeAddress& address, NodeKind kind, const Polyhedron& region,
                        std::span<const std::uint32_t> planes, const std::uint32_t* expression) {
    // The polyhedra of the parts that are still to be visited are the last ones in use, and the
    // nearest of them is on top.
    const std::size_t bottom = open_parts_.size();
    scratch() = region;
    open_parts_.push_back(expression);
    while (open_parts_.size() > bottom) {
      Polyhedron& part = storage_[used_ - 1];
      const std::uint32_t* const token = open_parts_.back();
      if (*token < kFirstPlaneToken) {
        if (*token == kInToken) emit(address, kind, part);
        open_parts_.pop_back();
        release();
        continue;
      }
      const PlaneRef plane = PlaneRef::of_table(planes[*token - kFirstPlaneToken]);
      const bool outside_first = viewpoint_ && viewer_is_outside(plane);
      const std::uint32_t* near_token = token + 1;
      const std::uint32_t* far_token = skip_expression(near_token);
      PlaneRef near_side = plane;
      if (outside_first) {
        std::swap(near_token, far_token);
        near_side = plane.flipped();
      }
      Polyhedron& near_part = scratch();
      const auto parts = clipper_.split(part, near_side, planes_, near_part, far_part_);
      if (parts.outside) {
        std::swap(part, far_part_);
        open_parts_.back() = far_token;
      } else {
        std::swap(part, near_part);
        open_parts_.back() = near_token;
      }
      if (parts.inside && parts.outside) {
        open_parts_.push_back(near_token);
      } else {
        release();
      }
    }
  }

  const Octree& tree_;
  const PlaneSet planes_;
  const std::size_t last_level_;
  const std::optional<Viewpoint> viewpoint_;
  const bool inner_nodes_only_;
  PieceVisitor& visitor_;
  PolyhedronClipper clipper_;
  std::deque<Polyhedron> storage_;  // a deque: references stay valid while it grows
  std::size_t used_ = 0;
  Polyhedron far_part_;                           // of the split at hand
  std::vector<const std::uint32_t*> open_parts_;  // where their expressions go on
  std::uint32_t part_ = 0;
};

}  // namespace

void walk_pieces(const Octree& tree, const WalkOptions& options, PieceVisitor& visitor) {
  Walker(tree, options, visitor).walk();
}

}  // namespace spoctree
