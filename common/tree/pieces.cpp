#include "common/tree/pieces.hpp"

#include <algorithm>
#include <deque>
#include <glm/geometric.hpp>

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
        visitor_(visitor) {}

  void walk() {
    const NodeAddress root;
    if (tree_.levels[0].kinds[0] == NodeKind::White) return;
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

  bool viewer_is_outside(PlaneRef ref) const {
    const Plane plane = planes_[ref];
    return glm::dot(plane.normal, viewpoint_->xyz) - plane.offset * viewpoint_->w > 0;
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
        visit_union(address, region, planes);
        break;
      case NodeKind::Vertex: {
        const std::uint32_t* token = level.expression_of(address.index).data();
        visit_expression(address, region, planes, token);
        break;
      }
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

  /// Splits by the middle walls of z, then y, then x, near halves first.
  void visit_children(const NodeAddress& parent, std::uint32_t first_child,
                      const Polyhedron& region, int axis, std::uint32_t octant) {
    const Level& children = tree_.levels[parent.level + 1];
    if (axis < 0) {
      if (children.kinds[first_child + octant] == NodeKind::White) return;
      Polyhedron& copy = scratch();
      copy = region;
      visit(parent.child(first_child, octant), copy);
      release();
      return;
    }
    const PlaneRef middle = PlaneRef::of_wall(axis, parent.lower[axis] + parent.size() / 2);
    const std::uint32_t near = viewpoint_ && viewer_is_outside(middle) ? 1 : 0;
    for (const std::uint32_t half : {near, 1 - near}) {
      Polyhedron& part = scratch();
      part = region;
      if (clip(part, half == 1 ? middle.flipped() : middle)) {
        visit_children(parent, first_child, part, axis - 1,
                       octant | half << static_cast<unsigned>(axis));
      }
      release();
    }
  }

  /// The union of half-spaces h1, h2, ...: h1, else h2, ... . Disjoint pieces by splitting.
  void visit_union(const NodeAddress& address, Polyhedron& region,
                   std::span<const std::uint32_t> planes) {
    if (planes.empty()) return;
    const PlaneRef plane = PlaneRef::of_table(planes.front());
    split(region, plane, [&](Polyhedron& part, bool inside) {
      if (inside) {
        emit(address, NodeKind::Concave, part);
      } else {
        visit_union(address, part, planes.subspan(1));
      }
    });
  }

  void visit_expression(const NodeAddress& address, Polyhedron& region,
                        std::span<const std::uint32_t> planes, const std::uint32_t* token) {
    if (*token == kOutToken) return;
    if (*token == kInToken) {
      emit(address, NodeKind::Vertex, region);
      return;
    }
    const PlaneRef plane = PlaneRef::of_table(planes[*token - kFirstPlaneToken]);
    const std::uint32_t* inside_token = token + 1;
    const std::uint32_t* outside_token = skip_expression(inside_token);
    split(region, plane, [&](Polyhedron& part, bool inside) {
      visit_expression(address, part, planes, inside ? inside_token : outside_token);
    });
  }

  static const std::uint32_t* skip_expression(const std::uint32_t* token) {
    for (std::size_t wanted = 1; wanted > 0; ++token) {
      wanted = *token < kFirstPlaneToken ? wanted - 1 : wanted + 1;
    }
    return token;
  }

  /// Calls `visit_part(part, is_inside)` for the two parts that have an interior, near one first.
  template <class VisitPart>
  void split(const Polyhedron& region, PlaneRef plane, VisitPart&& visit_part) {
    const bool outside_first = viewpoint_ && viewer_is_outside(plane);
    for (const bool inside : {!outside_first, outside_first}) {
      Polyhedron& part = scratch();
      part = region;
      if (clip(part, inside ? plane : plane.flipped())) visit_part(part, inside);
      release();
    }
  }

  const Octree& tree_;
  const PlaneSet planes_;
  const std::size_t last_level_;
  const std::optional<Viewpoint> viewpoint_;
  PieceVisitor& visitor_;
  PolyhedronClipper clipper_;
  std::deque<Polyhedron> storage_;  // a deque: references stay valid while it grows
  std::size_t used_ = 0;
  std::uint32_t part_ = 0;
};

}  // namespace

void walk_pieces(const Octree& tree, const WalkOptions& options, PieceVisitor& visitor) {
  Walker(tree, options, visitor).walk();
}

}  // namespace spoctree
