#include "common/tree/classify.hpp"

#include <algorithm>

#include "common/geometry/predicates.hpp"

namespace spoctree {

namespace {

/// In, Out or On: the value of an expression at a point. On if both sides of a plane through the
/// point disagree or are themselves On.
struct ExpressionReader {
  const Octree& tree;
  std::span<const std::uint32_t> planes;
  Vec3 point;

  PointClass read(const std::uint32_t*& token, bool wanted) const {
    const std::uint32_t here = *token++;
    if (here == kOutToken) return PointClass::Out;
    if (here == kInToken) return PointClass::In;
    const int side =
        wanted ? side_of_any_point(tree.planes[planes[here - kFirstPlaneToken]], point) : 0;
    const PointClass inside = read(token, wanted && side <= 0);
    const PointClass outside = read(token, wanted && side >= 0);
    if (side < 0) return inside;
    if (side > 0) return outside;
    return inside == outside ? inside : PointClass::On;
  }
};

}  // namespace

PointClass classify_point(const Octree& tree, Vec3 point, std::uint32_t level_limit) {
  const double half_side = tree.universe.half_side;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(point[axis]) <= half_side)) return PointClass::Out;
  }
  const std::size_t last_level = std::min<std::size_t>(level_limit, tree.levels.size() - 1);
  std::uint32_t lower[3] = {0, 0, 0};
  std::uint32_t node = 0;
  bool on_ancestor = false;
  for (std::size_t depth = 0;; ++depth) {
    const Level& level = tree.levels[depth];
    const NodeKind kind = level.kinds[node];
    const auto planes = level.planes_of(node);
    const auto answer = [&](PointClass inside) {
      return on_ancestor && inside == PointClass::In ? PointClass::On : inside;
    };
    switch (kind) {
      case NodeKind::White:
        return PointClass::Out;
      case NodeKind::Black:
        return answer(PointClass::In);
      case NodeKind::Convex:
      case NodeKind::Grey: {
        bool on = false;
        for (const std::uint32_t plane : planes) {
          const int side = side_of_any_point(tree.planes[plane], point);
          if (side > 0) return PointClass::Out;
          on |= side == 0;
        }
        if (kind == NodeKind::Convex) return on ? PointClass::On : answer(PointClass::In);
        on_ancestor |= on;
        break;
      }
      case NodeKind::Concave: {
        bool on = false;
        for (const std::uint32_t plane : planes) {
          const int side = side_of_any_point(tree.planes[plane], point);
          if (side < 0) return answer(PointClass::In);
          on |= side == 0;
        }
        return on ? PointClass::On : PointClass::Out;
      }
      case NodeKind::Vertex: {
        const std::uint32_t* token = level.expression_of(node).data();
        return answer(ExpressionReader{tree, planes, point}.read(token, true));
      }
    }
    if (depth == last_level) return PointClass::Unknown;
    const std::uint32_t half = std::uint32_t{1} << (kMaxDepth - static_cast<int>(depth) - 1);
    std::uint32_t octant = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      if (point[static_cast<int>(axis)] >= wall_coordinate(half_side, lower[axis] + half)) {
        octant |= 1u << axis;
        lower[axis] += half;
      }
    }
    node = level.first_child[node] + octant;
  }
}

}  // namespace spoctree
