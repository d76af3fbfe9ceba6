#include "tests/support/tree_definition.hpp"

#include <set>
#include <stdexcept>

namespace spoctree {

namespace {

Rational dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Box {
  RationalPoint lower;
  Rational side;
};

class Definition {
 public:
  Definition(const Octree& tree, std::uint32_t level, const RationalPoint& point,
             const RationalPoint& direction)
      : tree_(tree), level_(level), point_(point), direction_(direction) {}

  TreeValue value() const {
    const Rational half(tree_.universe.half_side);
    return value(0, 0, {{-half, -half, -half}, 2 * half});
  }

 private:
  /// normal . p - offset < 0 at the place.
  bool is_below(const RationalPoint& normal, const Rational& offset) const {
    const Rational here = dot(normal, point_) - offset;
    if (here != 0) return here < 0;
    const Rational there = dot(normal, direction_);
    if (there == 0) throw std::logic_error("a direction within a plane");
    return there < 0;
  }
  bool is_inside(std::uint32_t plane) const {
    return is_below(to_rational(tree_.planes[plane].normal), Rational(tree_.planes[plane].offset));
  }
  bool is_in_box(const Box& box) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      RationalPoint normal{0, 0, 0};
      normal[axis] = 1;
      if (is_below(normal, box.lower[axis])) return false;
      if (!is_below(normal, box.lower[axis] + box.side)) return false;
    }
    return true;
  }

  /// The value of a node at a place of its cube; no material outside.
  TreeValue value(std::uint32_t depth, std::uint32_t node, const Box& box) const {
    if (!is_in_box(box)) return {};
    const Level& level = tree_.levels[depth];
    bool in_all = true;
    bool in_any = false;
    for (const std::uint32_t plane : level.planes_of(node)) {
      const bool inside = is_inside(plane);
      in_all = in_all && inside;
      in_any = in_any || inside;
    }
    switch (level.kinds[node]) {
      case NodeKind::White:
        return {false, true};
      case NodeKind::Black:
        return {true, true};
      case NodeKind::Convex:
        return {in_all, true};
      case NodeKind::Concave:
        return {in_any, true};
      case NodeKind::Vertex: {
        const auto tokens = level.expression_of(node);
        std::size_t at = 0;
        return {expression_value(tokens, at, level.planes_of(node)), true};
      }
      case NodeKind::Grey:
        break;
    }
    if (!in_all) return {false, true};
    if (depth == level_) return {true, false};
    // The union of the children, clipped by the node's planes. The place is in one child's cube.
    std::uint32_t grey = 0;
    for (std::uint32_t i = 0; i < node; ++i) grey += level.kinds[i] == NodeKind::Grey;
    TreeValue result;
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      Box child{box.lower, box.side / 2};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if ((octant >> axis) & 1) child.lower[axis] += child.side;
      }
      const TreeValue part = value(depth + 1, 8 * grey + octant, child);
      result.is_material = result.is_material || part.is_material;
      result.is_known = result.is_known && part.is_known;
    }
    return result;
  }

  bool expression_value(std::span<const std::uint32_t> tokens, std::size_t& at,
                        std::span<const std::uint32_t> planes) const {
    const std::uint32_t token = tokens[at++];
    if (token == kOutToken) return false;
    if (token == kInToken) return true;
    const bool in_inside = expression_value(tokens, at, planes);
    const bool in_outside = expression_value(tokens, at, planes);
    return is_inside(planes[token - kFirstPlaneToken]) ? in_inside : in_outside;
  }

  const Octree& tree_;
  const std::uint32_t level_;
  const RationalPoint& point_;
  const RationalPoint& direction_;
};

}  // namespace

TreeValue value_of_definition(const Octree& tree, std::uint32_t level, const RationalPoint& point,
                              const RationalPoint& direction) {
  return Definition(tree, level, point, direction).value();
}

std::vector<RationalPoint> directions_around(const Octree& tree, std::uint32_t level,
                                             const RationalPoint& point) {
  // The normals of everything through the point, and three more so that every region is pointed.
  std::vector<RationalPoint> normals;
  const auto add = [&](const RationalPoint& normal) {
    for (const RationalPoint& old : normals) {
      const RationalPoint product = cross(old, normal);
      if (product[0] == 0 && product[1] == 0 && product[2] == 0) return;
    }
    normals.push_back(normal);
  };
  add({1, 0, 0});
  add({0, 1, 0});
  add({0, 0, 1});
  std::set<std::uint32_t> used;
  for (std::uint32_t k = 0; k <= level && k < tree.levels.size(); ++k) {
    used.insert(tree.levels[k].references.begin(), tree.levels[k].references.end());
  }
  for (const std::uint32_t plane : used) {
    if (exact_value(tree.planes[plane], point) == 0) add(to_rational(tree.planes[plane].normal));
  }
  // The sum of three edges of a pointed region, not all in one face, lies in its interior. Edges
  // are where two of the planes meet.
  std::vector<RationalPoint> edges;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const RationalPoint edge = cross(normals[i], normals[j]);
      edges.push_back(edge);
      edges.push_back({-edge[0], -edge[1], -edge[2]});
    }
  }
  std::vector<std::vector<int>> edge_signs;
  for (const RationalPoint& edge : edges) {
    auto& signs = edge_signs.emplace_back();
    for (const RationalPoint& normal : normals) signs.push_back(dot(normal, edge).sign());
  }
  std::vector<RationalPoint> directions;
  std::set<std::vector<int>> regions;
  for (std::size_t a = 0; a < edges.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (std::size_t c = 0; c < b; ++c) {
        // Edges of one region agree in all signs that are not 0; then so does their sum.
        std::vector<int> signs(normals.size(), 0);
        bool agree = true;
        for (std::size_t i = 0; i < signs.size() && agree; ++i) {
          for (const std::size_t edge : {a, b, c}) {
            const int sign = edge_signs[edge][i];
            agree = agree && (sign == 0 || signs[i] == 0 || sign == signs[i]);
            if (sign != 0) signs[i] = sign;
          }
          agree = agree && signs[i] != 0;
        }
        if (!agree || !regions.insert(signs).second) continue;
        RationalPoint sum;
        for (std::size_t i = 0; i < 3; ++i) sum[i] = edges[a][i] + edges[b][i] + edges[c][i];
        directions.push_back(sum);
      }
    }
  }
  return directions;
}

}  // namespace spoctree
