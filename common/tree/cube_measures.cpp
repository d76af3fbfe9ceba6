#include "common/tree/cube_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace spoctree {

namespace {

/// Meets every square in which two leaves of different colours touch once.
class ExposedSquares {
 public:
  explicit ExposedSquares(const Octree& tree) : tree_(tree), count_(tree.levels.size() + 1) {
    visit({0, 0});
    for (int axis = 0; axis < 3; ++axis) {
      visit_wall({0, 0}, kOutside, axis, 0);
      visit_wall(kOutside, {0, 0}, axis, 0);
    }
  }

  /// In sides of the universe cube, squared: of the BLACK leaves of a level.
  double area(std::size_t level_of_leaf) const {
    double area = 0;
    for (std::size_t k = 0; k < count_.size(); ++k) {
      area += std::ldexp(static_cast<double>(count_[level_of_leaf][k]), -2 * static_cast<int>(k));
    }
    return area;
  }

 private:
  struct Node {
    std::uint32_t level;
    std::uint32_t index;
  };
  static constexpr Node kOutside{static_cast<std::uint32_t>(-1), 0};

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
      if (below == above) return;
      ++count_[below == NodeKind::Black ? lower.level : upper.level][level];
      return;
    }
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      if ((octant >> axis) & 1) continue;
      visit_wall(below == NodeKind::Grey ? child(lower, octant | 1u << axis) : lower,
                 above == NodeKind::Grey ? child(upper, octant) : upper, axis, level + 1);
    }
  }

  const Octree& tree_;
  /// Per level of the BLACK leaf, the squares of each level's size.
  std::vector<std::array<std::uint64_t, kMaxDepth + 1>> count_;
};

}  // namespace

void measure_cubes(Octree& tree) {
  const ExposedSquares squares(tree);
  const double side = tree.universe.side();
  double inner = 0;  // in sides of the universe cube
  double inner_area = 0;
  for (std::size_t k = 0; k < tree.levels.size(); ++k) {
    Level& level = tree.levels[k];
    const auto blacks = std::count(level.kinds.begin(), level.kinds.end(), NodeKind::Black);
    const int exponent = -3 * static_cast<int>(k);
    inner += std::ldexp(static_cast<double>(blacks), exponent);
    inner_area += squares.area(k);
    level.statement.inner_volume = inner * (side * side * side);
    level.statement.outer_volume =
        (inner + std::ldexp(static_cast<double>(level.grey_count), exponent)) *
        (side * side * side);
    level.statement.inner_area = inner_area * (side * side);
  }
  for (Level& level : tree.levels) level.statement.outer_area = inner_area * (side * side);
}

}  // namespace spoctree
