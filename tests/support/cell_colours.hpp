// A tree of cubes -> the colours of the cells of one depth, in a plain array.
#pragma once

#include <cstdint>
#include <vector>

#include "common/tree/octree.hpp"

namespace spoctree::test {

/// 1 for black, 0 for white: cell (x, y, z) of 2^depth a side at x + side * (y + side * z). GREY
/// nodes of that depth are black. REQUIRES: no planes.
inline std::vector<std::uint8_t> cell_colours(const Octree& tree, int depth) {
  const std::size_t side = std::size_t{1} << depth;
  std::vector<std::uint8_t> cells(side * side * side);
  struct Item {
    std::size_t level, x, y, z;
    std::uint32_t index;
  };
  std::vector<Item> open{{0, 0, 0, 0, 0}};
  while (!open.empty()) {
    const Item item = open.back();
    open.pop_back();
    const Level& level = tree.levels[item.level];
    const NodeKind kind = level.kinds[item.index];
    if (kind == NodeKind::White) continue;
    if (kind == NodeKind::Grey && item.level < static_cast<std::size_t>(depth)) {
      for (std::uint32_t o = 0; o < 8; ++o) {
        open.push_back({item.level + 1, 2 * item.x + (o & 1), 2 * item.y + (o >> 1 & 1),
                        2 * item.z + (o >> 2), level.first_child[item.index] + o});
      }
      continue;
    }
    const std::size_t width = side >> item.level;
    for (std::size_t z = item.z * width; z < (item.z + 1) * width; ++z) {
      for (std::size_t y = item.y * width; y < (item.y + 1) * width; ++y) {
        for (std::size_t x = item.x * width; x < (item.x + 1) * width; ++x)
          cells[x + side * (y + side * z)] = 1;
      }
    }
  }
  return cells;
}

}  // namespace spoctree::test
