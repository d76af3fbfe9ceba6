// What can be chosen about an SP-Octree.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "common/tree/octree.hpp"

namespace spoctree {

/// A cell with at most so many remaining planes becomes a VERTEX leaf, even if they share no
/// vertex. Small at first, since planes in a large cell cost more bytes than they save distance;
/// larger from kGrowingFrom on, since in a small cell subdividing repeats planes and tells little.
/// Chosen on real meshes (tests/corpus/level_distances.cpp): fewer planes make scans finer at first
/// and everything larger in the end, more make the first levels of parts heavy.
inline constexpr std::uint32_t kLeafPlanes = 16;
inline constexpr std::uint32_t kMostLeafPlanes = 32;
inline constexpr std::uint32_t kGrowingFrom = 6;  ///< a depth
inline constexpr std::uint32_t kGrowthPerLevel = 4;

/// A cell of at most so many remaining planes becomes a VERTEX leaf, too, if it has as many of them
/// as the cell two levels above: planes that a gap holds together stay together until cells are as
/// small as the gap, and the tree would grow with its inverse.
inline constexpr std::uint32_t kMostUnseparatedPlanes = 128;

struct SpRules {
  /// The limit of remaining planes at every depth; 0: the paper's rule alone. Without it, the
  /// limits above.
  std::optional<std::uint32_t> leaf_planes;
  /// A cell at this depth becomes a VERTEX leaf whatever it holds.
  std::uint32_t max_depth = kMaxDepth;

  /// The limit of planes at a depth.
  std::uint32_t leaf_planes_at(std::uint32_t depth) const {
    if (leaf_planes) return *leaf_planes;
    const std::uint32_t levels = depth > kGrowingFrom ? depth - kGrowingFrom : 0;
    return std::min(kLeafPlanes + kGrowthPerLevel * levels, kMostLeafPlanes);
  }
  /// The same for cells in which subdividing has separated nothing.
  std::uint32_t unseparated_planes() const { return leaf_planes.value_or(kMostUnseparatedPlanes); }
};

/// The rule of Cano, Torres and Velasco alone.
inline constexpr SpRules kPaperRules{0, kMaxDepth};

}  // namespace spoctree
