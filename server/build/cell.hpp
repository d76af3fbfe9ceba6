// One cell of the subdivision, as the classifiers see it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "common/tree/octree.hpp"
#include "server/build/fragment.hpp"

namespace spoctree {

/// What is known of a corner of a cell: whether the cell's material reaches it. `Boundary` means
/// that the boundary of the solid passes exactly through it.
enum class CornerState : std::uint8_t { Outside, Inside, Boundary, Unknown };

inline constexpr std::uint32_t kManyPlanes = std::numeric_limits<std::uint32_t>::max();

/// A closed cell with the solid's boundary in it.
struct Cell {
  std::uint32_t depth = 0;
  std::uint32_t lower[3] = {0, 0, 0};  ///< wall indices, as in NodeAddress
  FragmentList boundary;
  std::array<CornerState, 8> corners{};  ///< in octant order
  /// Planes that no ancestor has taken: of this cell, once it was classified; of its parent and of
  /// that one's parent, or kManyPlanes where there is none.
  std::uint32_t remaining_planes = 0;
  std::array<std::uint32_t, 2> planes_above{kManyPlanes, kManyPlanes};

  std::uint32_t size() const { return std::uint32_t{1} << (kMaxDepth - static_cast<int>(depth)); }
  double wall(const Solid& solid, int axis, bool upper) const {
    return wall_coordinate(solid.universe.half_side, lower[axis] + (upper ? size() : 0));
  }
  Vec3 corner_position(const Solid& solid, unsigned octant) const {
    Vec3 position;
    for (int axis = 0; axis < 3; ++axis) position[axis] = wall(solid, axis, (octant >> axis) & 1);
    return position;
  }
  Vec3 centre(const Solid& solid) const {
    return 0.5 * (corner_position(solid, 0) + corner_position(solid, 7));
  }
};

/// What a classifier decides.
struct Decision {
  NodeKind kind = NodeKind::White;
  std::vector<std::uint32_t> planes;  ///< of the solid
  std::vector<std::uint32_t> tokens;  ///< of a VERTEX node
  /// For GREY nodes and the partial cells of classical trees: a triangle of the solid that touches
  /// the cell (for the error bound).
  std::uint32_t witness = 0;
  bool is_depth_limited = false;  ///< a leaf only because of the depth limit

  void clear() {
    is_depth_limited = false;
    planes.clear();
    tokens.clear();
  }
};

}  // namespace spoctree
