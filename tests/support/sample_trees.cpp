#include "tests/support/sample_trees.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace spoctree {

namespace {

double to_grid(double value) {
  return std::ldexp(std::nearbyint(std::ldexp(value, kGridBits)), -kGridBits);
}

Vec3 to_grid(Vec3 value) { return {to_grid(value.x), to_grid(value.y), to_grid(value.z)}; }

Plane plane_through(Vec3 direction, Vec3 point) {
  const Vec3 normal = glm::normalize(direction);
  return {to_grid(normal), to_grid(glm::dot(normal, point))};
}

Universe unit_universe() {
  Universe universe;
  universe.center = {10, 20, 30};
  universe.scale_exponent = 1;
  universe.half_side = 0.75;
  return universe;
}

/// Six planes of an axis-parallel cube: +x, -x, +y, ...
std::vector<Plane> cube_planes(double half) {
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      Plane plane;
      plane.normal[axis] = sign;
      plane.offset = half;
      planes.push_back(plane);
    }
  }
  return planes;
}

Vec3 random_direction(Random& random) {
  while (true) {
    const Vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double length = glm::length(v);
    if (length > 0.1 && length <= 1) return v;
  }
}

/// One node whose children are still to be drawn.
struct Pending {
  Vec3 center;
  double half;
  std::vector<std::uint32_t> ancestors;  ///< planes that must not be repeated below
};

class RandomTree {
 public:
  RandomTree(std::uint64_t seed, const RandomTreeOptions& options)
      : random_(seed), options_(options) {}

  Octree draw() {
    for (int axis = 0; axis < 3; ++axis) tree_.universe.center[axis] = random_.between(-500, 500);
    tree_.universe.scale_exponent = static_cast<int>(random_.below(40)) - 20;
    tree_.universe.half_side = std::ldexp((1u << 19) + 1 + random_.below(1u << 19), -kHalfSideBits);
    std::vector<Pending> cells{{Vec3(0.0), tree_.universe.half_side, {}}};
    double error = random_.between(0.5, 1);
    for (std::uint32_t depth = 0; !cells.empty(); ++depth) {
      std::vector<Pending> next;
      Level& level = tree_.levels.emplace_back();
      for (const Pending& cell : cells) draw_node(cell, depth, level, next);
      error = next.empty() ? 0 : error * random_.unit();
      level.statement = {error, next.empty() ? 1.0 : random_.unit(), 1 + error, 2 * random_.unit(), 2 + error};
      cells = std::move(next);
    }
    return std::move(tree_);
  }

 private:
  void draw_node(const Pending& cell, std::uint32_t depth, Level& level,
                 std::vector<Pending>& next) {
    const bool may_split = depth + 1 < options_.levels && node_count_ + 8 <= options_.max_nodes;
    const bool splits = may_split && (depth == 0 || random_.chance(options_.grey_chance));
    constexpr NodeKind kLeaves[] = {NodeKind::White, NodeKind::Black, NodeKind::Convex,
                                    NodeKind::Concave, NodeKind::Vertex};
    const NodeKind kind = splits ? NodeKind::Grey : kLeaves[random_.below(5)];
    std::uint32_t wanted = random_.below(options_.max_planes_per_node + 1);
    if (kind == NodeKind::White || kind == NodeKind::Black) wanted = 0;
    if (kind == NodeKind::Convex) wanted = std::max(wanted, 1u);
    if (kind == NodeKind::Concave) wanted = std::max(wanted, 2u);
    if (kind == NodeKind::Vertex) wanted = std::max(wanted, 3u);

    std::vector<std::uint32_t> planes;
    while (planes.size() < wanted) planes.push_back(draw_plane(cell, planes));
    std::vector<std::uint32_t> expression;
    if (kind == NodeKind::Vertex) draw_expression(wanted, 4, expression);
    level.append(kind, planes, expression);
    ++node_count_;
    if (!splits) return;
    planes.insert(planes.end(), cell.ancestors.begin(), cell.ancestors.end());
    for (int octant = 0; octant < 8; ++octant) {
      const Vec3 shift{octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1};
      next.push_back({cell.center + shift * (cell.half / 2), cell.half / 2, planes});
    }
    node_count_ += 8;
  }

  std::uint32_t draw_plane(const Pending& cell, const std::vector<std::uint32_t>& own) {
    const auto count = static_cast<std::uint32_t>(tree_.planes.size());
    if (count > 0 && random_.chance(options_.reuse_chance)) {
      // Mostly recent ones, as neighbours share them.
      const std::uint32_t window = random_.chance(0.9) ? std::min(count, 64u) : count;
      const std::uint32_t plane = count - 1 - random_.below(window);
      const auto has = [&](const std::vector<std::uint32_t>& planes) {
        return std::find(planes.begin(), planes.end(), plane) != planes.end();
      };
      if (!has(own) && !has(cell.ancestors)) return plane;
    }
    tree_.planes.push_back(random_plane(random_, cell.center, cell.half));
    return count;
  }

  void draw_expression(std::uint32_t planes, int depth, std::vector<std::uint32_t>& tokens) {
    if (depth == 0 || (depth < 4 && random_.chance(0.3))) {
      tokens.push_back(random_.chance(0.5) ? kInToken : kOutToken);
      return;
    }
    tokens.push_back(kFirstPlaneToken + random_.below(planes));
    draw_expression(planes, depth - 1, tokens);
    draw_expression(planes, depth - 1, tokens);
  }

  Random random_;
  RandomTreeOptions options_;
  Octree tree_;
  std::uint32_t node_count_ = 0;  ///< children of GREY nodes counted twice: a rough bound
};

}  // namespace

Octree cube_tree() {
  Octree tree;
  tree.universe = unit_universe();
  tree.planes = cube_planes(0.5);
  Level root;
  const std::uint32_t planes[] = {0, 1, 2, 3, 4, 5};
  root.append(NodeKind::Convex, planes);
  root.statement = {0, 8, 8, 24, 24};
  tree.levels.push_back(root);
  return tree;
}

Octree every_kind_tree() {
  Octree tree;
  tree.universe = unit_universe();
  tree.planes = cube_planes(0.5);
  tree.planes.push_back(plane_through({1, 1, 0}, {0.25, 0.25, 0}));
  tree.planes.push_back(plane_through({0, -1, 2}, {0, 0.125, 0.25}));
  Level root;
  const std::uint32_t first[] = {0};
  root.append(NodeKind::Grey, first);
  root.statement = {1.5, 0, 9, 0, 26};
  Level middle;
  const std::uint32_t one[] = {1}, two[] = {2, 1}, three[] = {3, 1, 4}, four[] = {4, 5};
  const std::uint32_t corner[] = {kFirstPlaneToken + 0,
                                  kFirstPlaneToken + 2,
                                  kInToken,
                                  kOutToken,
                                  kFirstPlaneToken + 1,
                                  kOutToken,
                                  kInToken};
  middle.append(NodeKind::White, {});
  middle.append(NodeKind::Convex, one);
  middle.append(NodeKind::Concave, two);
  middle.append(NodeKind::Grey, {});
  middle.append(NodeKind::Vertex, three, corner);
  middle.append(NodeKind::Black, {});
  middle.append(NodeKind::Convex, four);
  middle.append(NodeKind::Black, {});
  middle.statement = {0.25, 5, 8.5, 11.5, 25.25};
  Level bottom;
  const std::uint32_t five[] = {6, 2}, six[] = {7, 6, 3};
  for (int i = 0; i < 6; ++i) bottom.append(i % 2 == 0 ? NodeKind::White : NodeKind::Black, {});
  bottom.append(NodeKind::Concave, five);
  bottom.append(NodeKind::Convex, six);
  bottom.statement = {0, 8, 8, 24, 24};
  tree.levels = {root, middle, bottom};
  return tree;
}

Octree many_planes_tree(std::uint32_t plane_count) {
  Octree tree;
  tree.universe = unit_universe();
  Random random(plane_count);
  Level root;
  std::vector<std::uint32_t> planes;
  for (std::uint32_t i = 0; i < plane_count; ++i) {
    const Vec3 direction = random_direction(random);
    tree.planes.push_back(plane_through(direction, glm::normalize(direction) * 0.5));
    planes.push_back(i);
  }
  root.append(NodeKind::Convex, planes);
  tree.levels.push_back(root);
  return tree;
}

Plane random_plane(Random& random, Vec3 center, double half) {
  const Vec3 point =
      center + half * Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
  return plane_through(random_direction(random), point);
}

Octree random_tree(std::uint64_t seed, const RandomTreeOptions& options) {
  return RandomTree(seed, options).draw();
}

bool are_equal(const Octree& a, const Octree& b) {
  return a.universe == b.universe && a.planes == b.planes &&
         std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(),
                    [](const Level& x, const Level& y) {
                      return x.kinds == y.kinds && x.first_child == y.first_child &&
                             x.reference_begin == y.reference_begin &&
                             x.references == y.references && x.token_begin == y.token_begin &&
                             x.tokens == y.tokens && x.grey_count == y.grey_count &&
                             x.statement == y.statement;
                    });
}

}  // namespace spoctree
