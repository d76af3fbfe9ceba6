#include "server/silhouettes/state_levels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "common/tree/cube_measures.hpp"

namespace spoctree {

namespace {

/// More than the sums below can be off.
constexpr double kRounding = 1 + 0x1p-48;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// For each node of a level, how far its points can be from material in the node at most: kInfinite
/// for WHITE, 0 for BLACK. `below` says it of the next level, `side` is that of the level's cubes.
std::vector<double> reach_of_level(const Level& level, double side,
                                   const std::vector<double>& below) {
  std::array<double, 4> moves{};  // to a child that is the neighbour along 0 to 3 axes
  for (std::size_t axes = 0; axes < 4; ++axes)
    moves[axes] = side / 2 * std::sqrt(static_cast<double>(axes));
  std::vector<double> reach(level.size());
  for (std::uint32_t i = 0; i < level.size(); ++i) {
    if (level.kinds[i] != NodeKind::Grey) {
      reach[i] = level.kinds[i] == NodeKind::Black ? 0 : kInfinite;
      continue;
    }
    const double* const children = below.data() + level.first_child[i];
    for (unsigned from = 0; from < 8; ++from) {
      double best = kInfinite;
      for (unsigned to = 0; to < 8; ++to) {
        const auto axes = static_cast<std::size_t>(std::popcount(from ^ to));
        best = std::min(best, moves[axes] + children[to]);
      }
      reach[i] = std::max(reach[i], best);
    }
  }
  return reach;
}

}  // namespace

void state_levels_of_cubes(Octree& tree) {
  measure_cubes(tree);
  const std::size_t count = tree.levels.size();
  const double side = tree.universe.side();
  std::vector<double> reach;
  for (std::size_t k = count; k-- > 0;) {
    const Level& level = tree.levels[k];
    reach = reach_of_level(level, std::ldexp(side, -static_cast<int>(k)), reach);
    double bound = 0;
    for (std::uint32_t i = 0; i < level.size(); ++i) {
      if (level.kinds[i] == NodeKind::Grey) bound = std::max(bound, reach[i]);
    }
    tree.levels[k].statement.error_bound = bound * kRounding;
  }
  // T_k lies in T_k-1: what bounds the one bounds the other.
  for (std::size_t k = 1; k < count; ++k) {
    double& bound = tree.levels[k].statement.error_bound;
    bound = std::min(bound, tree.levels[k - 1].statement.error_bound);
  }
}

}  // namespace spoctree
