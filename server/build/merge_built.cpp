#include "server/build/merge_built.hpp"

#include <utility>

#include "common/base/errors.hpp"
#include "common/tree/merge_siblings.hpp"

namespace spoctree {

namespace {

constexpr auto kNone = static_cast<std::uint32_t>(-1);

/// A triangle for every node of a level whose cell is mixed, kNone for the others.
std::vector<std::uint32_t> witness_of_nodes(const BuiltOctree& built, std::size_t k) {
  const Level& level = built.tree.levels[k];
  std::vector<std::uint32_t> witness(level.size(), kNone);
  for (std::uint32_t node = 0; node < level.size(); ++node) {
    if (level.kinds[node] != NodeKind::Grey) continue;
    witness[node] = built.witnesses[k][level.first_child[node] / 8];
  }
  for (const PartialCell& cell : built.partial_cells[k]) witness[cell.node] = cell.witness;
  return witness;
}

}  // namespace

void merge_siblings(BuiltOctree& built) {
  std::vector<std::vector<std::uint32_t>> witness;
  for (std::size_t k = 0; k < built.tree.levels.size(); ++k) {
    witness.push_back(witness_of_nodes(built, k));
  }
  const auto former = merge_siblings(built.tree);
  if (built.tree.levels[0].kinds[0] == NodeKind::White) {
    throw BadInput(
        "no cell of this depth is counted as full: nothing would be left of the solid (a larger "
        "--max-depth, or --partial full, keeps some of it)");
  }
  built.witnesses.assign(former.size(), {});
  built.partial_cells.assign(former.size(), {});
  built.leaf_volumes.clear();
  built.leaf_areas.clear();
  built.depth_limited_nodes = 0;
  for (std::size_t k = 0; k < former.size(); ++k) {
    const Level& level = built.tree.levels[k];
    for (std::uint32_t node = 0; node < level.size(); ++node) {
      const std::uint32_t triangle = witness[k][former[k][node]];
      if (triangle == kNone) continue;
      if (level.kinds[node] == NodeKind::Grey) {
        built.witnesses[k].push_back(triangle);
      } else {
        built.partial_cells[k].push_back({node, triangle});
      }
    }
    built.depth_limited_nodes += built.partial_cells[k].size();
  }
}

}  // namespace spoctree
