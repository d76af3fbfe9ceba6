#include "common/tree/cube_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace spoctree {

namespace {

struct Node {
  std::uint32_t level;
  std::uint32_t index;
};
constexpr Node kOutside{static_cast<std::uint32_t>(-1), 0};

/// Meets every square in which a BLACK leaf and a WHITE one, or the outside, touch once: calls
/// found(node of the BLACK leaf, level of whose cells' size the square is).
template <class Found>
class BoundarySquares {
 public:
  BoundarySquares(const Octree& tree, Found found) : tree_(tree), found_(std::move(found)) {
    visit({0, 0});
    for (int axis = 0; axis < 3; ++axis) {
      visit_wall({0, 0}, kOutside, axis, 0);
      visit_wall(kOutside, {0, 0}, axis, 0);
    }
  }

 private:
  NodeKind kind(const Node& node) const {
    if (node.level == kOutside.level) return NodeKind::White;
    return tree_.levels[node.level].kinds[node.index];
  }
  Node child(const Node& node, std::uint32_t octant) const {
    return {node.level + 1, tree_.levels[node.level].first_child[node.index] + octant};
  }

  void visit(const Node& node) {
    if (kind(node) != NodeKind::Grey) return;
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      visit(child(node, octant));
      for (int axis = 0; axis < 3; ++axis) {
        if ((octant >> axis) & 1) continue;
        visit_wall(child(node, octant), child(node, octant | 1u << axis), axis, node.level + 1);
      }
    }
  }

  /// The wall across `axis` that two nodes share, as large as a cell of `level`.
  void visit_wall(const Node& lower, const Node& upper, int axis, std::uint32_t level) {
    const NodeKind below = kind(lower);
    const NodeKind above = kind(upper);
    if (below != NodeKind::Grey && above != NodeKind::Grey) {
      if (below != above) found_(below == NodeKind::Black ? lower : upper, level);
      return;
    }
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      if ((octant >> axis) & 1) continue;
      visit_wall(below == NodeKind::Grey ? child(lower, octant | 1u << axis) : lower,
                 above == NodeKind::Grey ? child(upper, octant) : upper, axis, level + 1);
    }
  }

  const Octree& tree_;
  Found found_;
};

/// In sides of the universe cube, squared: the boundary on the BLACK leaves of each level.
std::vector<double> areas_by_level(const Octree& tree) {
  // Squares of each size, for an exact sum.
  std::vector<std::array<std::uint64_t, kMaxDepth + 1>> count(tree.levels.size());
  BoundarySquares(tree, [&](const Node& leaf, std::uint32_t level) { ++count[leaf.level][level]; });
  std::vector<double> areas(count.size(), 0.0);
  for (std::size_t k = 0; k < count.size(); ++k) {
    for (int size = 0; size <= kMaxDepth; ++size) {
      const auto squares = static_cast<double>(count[k][static_cast<std::size_t>(size)]);
      areas[k] += std::ldexp(squares, -2 * size);
    }
  }
  return areas;
}

}  // namespace

void measure_cubes(Octree& tree) {
  const std::vector<double> areas = areas_by_level(tree);
  const double side = tree.universe.side();
  double inner = 0;  // in sides of the universe cube
  double inner_area = 0;
  for (std::size_t k = 0; k < tree.levels.size(); ++k) {
    Level& level = tree.levels[k];
    const auto blacks = std::count(level.kinds.begin(), level.kinds.end(), NodeKind::Black);
    const int exponent = -3 * static_cast<int>(k);
    inner += std::ldexp(static_cast<double>(blacks), exponent);
    inner_area += areas[k];
    level.statement.inner_volume = inner * (side * side * side);
    level.statement.outer_volume =
        (inner + std::ldexp(static_cast<double>(level.grey_count), exponent)) *
        (side * side * side);
    level.statement.inner_area = inner_area * (side * side);
  }
  for (Level& level : tree.levels) level.statement.outer_area = inner_area * (side * side);
}

std::uint64_t count_exposed_cubes(const Octree& tree) {
  std::vector<std::vector<bool>> is_exposed;
  for (const Level& level : tree.levels) is_exposed.emplace_back(level.size(), false);
  BoundarySquares(
      tree, [&](const Node& leaf, std::uint32_t) { is_exposed[leaf.level][leaf.index] = true; });
  std::uint64_t count = 0;
  for (const auto& level : is_exposed) {
    count += static_cast<std::uint64_t>(std::count(level.begin(), level.end(), true));
  }
  return count;
}

}  // namespace spoctree
