// Tree -> the universe cube as a binary space partition, with the empty convex cells between the
// pieces of T_level.
#pragma once

#include <cstdint>
#include <vector>

#include "common/base/progress_meter.hpp"
#include "common/geometry/polyhedron.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// The octree's walls, the planes of its nodes and its leaves' expressions, each where it divides
/// what is there, in the order in which pieces are cut (LevelPieces). Cells of the partition are
/// material or empty.
struct SpacePartition {
  /// A split has the numbers of two others; instead of one may stand kMaterial, or an empty cell.
  using Child = std::int32_t;
  static constexpr Child kMaterial = -1;
  static constexpr Child empty_cell(std::uint32_t cell) { return -2 - static_cast<Child>(cell); }
  static constexpr bool is_empty_cell(Child child) { return child < kMaterial; }
  static constexpr std::uint32_t cell_of(Child child) {
    return static_cast<std::uint32_t>(-2 - child);
  }

  struct Split {
    PlaneRef plane;
    Child inside = kMaterial;
    Child outside = kMaterial;
  };

  std::vector<Split> splits;
  Child root = kMaterial;
  std::vector<Polyhedron> cells;  ///< the empty ones
  double material_volume = 0;     ///< universe units; for whoever wants to check
};

/// What is more than this is BadInput. Less only to try it out.
inline constexpr std::size_t kMostEmptyCells = std::size_t{1} << 30;

/// The partition of T_level; levels beyond the tree mean its last level. Exact: the cells have the
/// combinatorial structure of the exact ones, and together with the pieces of T_level they are the
/// universe cube. Time about that of finding the pieces, and O(planes * corners) of large convex
/// nodes. Throws BadInput if there are more than `most` empty cells, or what `progress` throws.
/// REQUIRES: a valid tree (validate.hpp) with at least one level.
SpacePartition partition_space(const Octree& tree, std::uint32_t level,
                               const ProgressShare& progress = {},
                               std::size_t most = kMostEmptyCells);

}  // namespace spoctree
