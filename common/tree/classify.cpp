#include "common/tree/classify.hpp"

#include <algorithm>
#include <optional>

#include "common/geometry/polyhedron_clipper.hpp"
#include "common/geometry/predicates.hpp"
#include "common/tree/expression.hpp"

namespace spoctree {

namespace {

/// What an infinitely small ball around the point holds, where planes or walls pass through the
/// point. A region of the tree cuts a convex cone out of that ball: the directions that lead from
/// the point into the region. Cones are polyhedra around the origin (any cube cut by planes through
/// the origin), so the exact clipping of regions serves for them too.
class Neighbourhood {
 public:
  Neighbourhood(const Octree& tree, Vec3 point, std::size_t last_level)
      : tree_(tree), point_(point), last_level_(last_level) {}

  PointClass classify() {
    const std::uint32_t whole[3] = {0, 0, 0};
    Polyhedron cone = make_cell(whole, std::uint32_t{1} << kMaxDepth, planes());
    const double half_side = tree_.universe.half_side;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(point_[axis]) != half_side) continue;
      has_out_ = true;  // beyond the universe cube
      clip(cone, half_towards(axis, point_[axis] < 0));
    }
    const std::uint32_t lower[3] = {0, 0, 0};
    visit(0, 0, lower, cone);
    if (has_in_ && has_out_) return PointClass::On;
    if (has_unknown_) return PointClass::Unknown;
    return has_in_ ? PointClass::In : PointClass::Out;
  }

 private:
  PlaneSet planes() const { return {normals_, 1.0}; }

  bool clip(Polyhedron& cone, PlaneRef plane) {
    return clipper_.clip(cone, plane, planes()) != ClipResult::Empty;
  }
  /// The part of `cone` on the inner side of `plane`, if it has an interior.
  std::optional<Polyhedron> part_of(const Polyhedron& cone, PlaneRef plane) {
    Polyhedron part = cone;
    if (!clip(part, plane)) return std::nullopt;
    return part;
  }
  /// The directions to one side of the wall through the point.
  static PlaneRef half_towards(int axis, bool upper) {
    const PlaneRef wall = PlaneRef::of_wall(axis, std::uint32_t{1} << (kMaxDepth - 1));
    return upper ? wall.flipped() : wall;
  }
  /// The directions that lead into the half-space of a plane through the point.
  PlaneRef half_of(std::uint32_t plane) {
    normals_.push_back({tree_.planes[plane].normal, 0});
    return PlaneRef::of_table(static_cast<std::uint32_t>(normals_.size() - 1));
  }

  bool is_settled() const { return has_in_ && has_out_; }

  void visit(std::size_t depth, std::uint32_t node, const std::uint32_t (&lower)[3],
             Polyhedron& cone) {
    if (is_settled()) return;
    const Level& level = tree_.levels[depth];
    const auto planes = level.planes_of(node);
    switch (level.kinds[node]) {
      case NodeKind::White:
        has_out_ = true;
        break;
      case NodeKind::Black:
        has_in_ = true;
        break;
      case NodeKind::Convex:
        if (stays_inside(cone, planes)) has_in_ = true;
        break;
      case NodeKind::Concave:
        read(union_of(static_cast<std::uint32_t>(planes.size())), planes, cone);
        break;
      case NodeKind::Vertex:
        read(level.expression_of(node), planes, cone);
        break;
      case NodeKind::Grey:
        if (!stays_inside(cone, planes)) break;
        if (depth == last_level_) {
          has_unknown_ = true;
        } else {
          visit_children(depth, level.first_child[node], lower, cone);
        }
        break;
    }
  }

  /// Clips `cone` by the half-spaces of `planes`; what they cut off is out. False if nothing stays.
  bool stays_inside(Polyhedron& cone, std::span<const std::uint32_t> planes) {
    for (const std::uint32_t plane : planes) {
      const int side = side_of_any_point(tree_.planes[plane], point_);
      if (side < 0) continue;
      if (side > 0) {
        has_out_ = true;
        return false;
      }
      const PlaneRef half = half_of(plane);
      if (!has_out_ && part_of(cone, half.flipped())) has_out_ = true;
      if (!clip(cone, half)) return false;
    }
    return true;
  }

  void visit_children(std::size_t depth, std::uint32_t first_child, const std::uint32_t (&lower)[3],
                      const Polyhedron& cone) {
    const std::uint32_t half = std::uint32_t{1} << (kMaxDepth - static_cast<int>(depth) - 1);
    for (std::uint32_t octant = 0; octant < 8 && !is_settled(); ++octant) {
      Polyhedron part = cone;
      std::uint32_t child_lower[3];
      bool touches = true;
      for (int axis = 0; axis < 3 && touches; ++axis) {
        const bool upper = ((octant >> axis) & 1) != 0;
        const double wall = wall_coordinate(tree_.universe.half_side, lower[axis] + half);
        if (point_[axis] == wall) {
          touches = clip(part, half_towards(axis, upper));
        } else {
          touches = upper == (point_[axis] > wall);
        }
        child_lower[axis] = lower[axis] + (upper ? half : 0);
      }
      if (touches) visit(depth + 1, first_child + octant, child_lower, part);
    }
  }

  /// What an expression says in the directions of `cone`.
  void read(std::span<const std::uint32_t> tokens, std::span<const std::uint32_t> planes,
            const Polyhedron& cone) {
    struct Open {
      const std::uint32_t* token;
      Polyhedron cone;
    };
    std::vector<Open> open{{tokens.data(), cone}};
    while (!open.empty() && !is_settled()) {
      Open part = std::move(open.back());
      open.pop_back();
      const std::uint32_t here = *part.token;
      if (here == kOutToken) has_out_ = true;
      if (here == kInToken) has_in_ = true;
      if (here < kFirstPlaneToken) continue;
      const std::uint32_t plane = planes[here - kFirstPlaneToken];
      const int side = side_of_any_point(tree_.planes[plane], point_);
      const std::uint32_t* const inside = part.token + 1;
      if (side < 0) {
        open.push_back({inside, std::move(part.cone)});
        continue;
      }
      const std::uint32_t* const outside = skip_expression(inside);
      if (side > 0) {
        open.push_back({outside, std::move(part.cone)});
        continue;
      }
      const PlaneRef half = half_of(plane);
      if (auto beyond = part_of(part.cone, half.flipped())) {
        open.push_back({outside, std::move(*beyond)});
      }
      if (clip(part.cone, half)) open.push_back({inside, std::move(part.cone)});
    }
  }

  const Octree& tree_;
  const Vec3 point_;
  const std::size_t last_level_;
  std::vector<Plane> normals_;  ///< of the planes met that contain the point, moved to the origin
  PolyhedronClipper clipper_;
  bool has_in_ = false;
  bool has_out_ = false;
  bool has_unknown_ = false;
};

/// What an expression says at a point; nothing if one of its planes on the way contains the point.
std::optional<PointClass> read(const std::uint32_t* token, const Octree& tree,
                               std::span<const std::uint32_t> planes, Vec3 point) {
  while (*token >= kFirstPlaneToken) {
    const int side = side_of_any_point(tree.planes[planes[*token - kFirstPlaneToken]], point);
    if (side == 0) return std::nullopt;
    token = side < 0 ? token + 1 : skip_expression(token + 1);
  }
  return *token == kInToken ? PointClass::In : PointClass::Out;
}

/// The answer for a point inside the universe cube that lies on none of the planes and walls met on
/// the way to its leaf; nothing for others.
std::optional<PointClass> classify_generic_point(const Octree& tree, Vec3 point,
                                                 std::size_t last_level) {
  const double half_side = tree.universe.half_side;
  std::uint32_t lower[3] = {0, 0, 0};
  std::uint32_t node = 0;
  for (std::size_t depth = 0;; ++depth) {
    const Level& level = tree.levels[depth];
    const NodeKind kind = level.kinds[node];
    const auto planes = level.planes_of(node);
    if (kind == NodeKind::White) return PointClass::Out;
    if (kind == NodeKind::Black) return PointClass::In;
    if (kind == NodeKind::Vertex)
      return read(level.expression_of(node).data(), tree, planes, point);
    // One plane with the point on this side decides: outside one of an intersection, inside one of
    // a union.
    const int deciding = kind == NodeKind::Concave ? -1 : 1;
    bool is_on = false;
    for (const std::uint32_t plane : planes) {
      const int side = side_of_any_point(tree.planes[plane], point);
      if (side == deciding) return deciding > 0 ? PointClass::Out : PointClass::In;
      is_on |= side == 0;
    }
    if (is_on) return std::nullopt;
    if (kind == NodeKind::Concave) return PointClass::Out;
    if (kind == NodeKind::Convex) return PointClass::In;
    if (depth == last_level) return PointClass::Unknown;
    const std::uint32_t half = std::uint32_t{1} << (kMaxDepth - static_cast<int>(depth) - 1);
    std::uint32_t octant = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const double coordinate = point[static_cast<int>(axis)];
      const double wall = wall_coordinate(half_side, lower[axis] + half);
      if (coordinate == wall) return std::nullopt;
      if (coordinate < wall) continue;
      octant |= 1u << axis;
      lower[axis] += half;
    }
    node = level.first_child[node] + octant;
  }
}

}  // namespace

PointClass classify_point(const Octree& tree, Vec3 point, std::uint32_t level) {
  const double half_side = tree.universe.half_side;
  bool on_boundary = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(point[axis]) <= half_side)) return PointClass::Out;
    on_boundary |= std::abs(point[axis]) == half_side;
  }
  const std::size_t last_level = std::min<std::size_t>(level, tree.levels.size() - 1);
  if (!on_boundary) {
    if (const auto answer = classify_generic_point(tree, point, last_level)) return *answer;
  }
  return Neighbourhood(tree, point, last_level).classify();
}

}  // namespace spoctree
