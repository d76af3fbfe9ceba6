#include "common/tree/merge_siblings.hpp"

#include <algorithm>
#include <utility>

namespace spoctree {

namespace {

/// What a GREY node is whose first child this is: Grey, unless all eight are leaves of one colour.
NodeKind merged_kind(const std::vector<NodeKind>& kinds, std::uint32_t first_child) {
  const NodeKind colour = kinds[first_child];
  if (colour != NodeKind::White && colour != NodeKind::Black) return NodeKind::Grey;
  const auto first = kinds.begin() + first_child;
  return std::all_of(first, first + 8, [&](NodeKind kind) { return kind == colour; })
             ? colour
             : NodeKind::Grey;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> merge_siblings(Octree& tree) {
  std::vector<std::vector<NodeKind>> kinds;
  for (const Level& level : tree.levels) kinds.push_back(level.kinds);
  for (std::size_t k = tree.levels.size(); k-- > 0;) {
    const Level& level = tree.levels[k];
    for (std::uint32_t node = 0; node < level.size(); ++node) {
      if (level.kinds[node] != NodeKind::Grey || !level.planes_of(node).empty()) continue;
      kinds[k][node] = merged_kind(kinds[k + 1], level.first_child[node]);
    }
  }
  std::vector<std::vector<std::uint32_t>> kept{{0}};
  std::vector<Level> levels;
  for (std::size_t k = 0; !kept[k].empty(); ++k) {
    const Level& from = tree.levels[k];
    Level& to = levels.emplace_back();
    to.statement = from.statement;
    std::vector<std::uint32_t> below;
    for (const std::uint32_t node : kept[k]) {
      to.append(kinds[k][node], from.planes_of(node), from.expression_of(node));
      if (kinds[k][node] != NodeKind::Grey) continue;
      for (std::uint32_t i = 0; i < 8; ++i) below.push_back(from.first_child[node] + i);
    }
    kept.push_back(std::move(below));
  }
  kept.pop_back();
  tree.levels = std::move(levels);
  return kept;
}

}  // namespace spoctree
