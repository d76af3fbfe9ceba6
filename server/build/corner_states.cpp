#include "server/build/corner_states.hpp"

#include <bit>

namespace spoctree {

namespace {

constexpr unsigned kEdgeCount = 12;

/// The edges of a cell: along `axis`, from corner `lower` to lower | 1 << axis.
unsigned edge_index(unsigned axis, unsigned lower) {
  // The two bits of `lower` other than `axis`, packed.
  const unsigned below = lower & ((1u << axis) - 1);
  const unsigned above = (lower >> (axis + 1)) << axis;
  return 4 * axis + (below | above);
}

unsigned lower_corner(unsigned edge) {
  const unsigned axis = edge / 4;
  const unsigned packed = edge % 4;
  return (packed & ((1u << axis) - 1)) | ((packed >> axis) << (axis + 1));
}

}  // namespace

void propagate_corner_states(const Solid& solid, Cell& cell) {
  unsigned crossed = 0;  // bit per edge: an odd number of faces cross it
  unsigned touched = 0;  // bit per edge: met in a way that tells nothing
  for (const FragmentCorner& corner : cell.boundary.corners) {
    if ((corner.pinned & (corner.pinned - 1)) == 0) continue;  // on one wall at most
    unsigned octant = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const int a = static_cast<int>(axis);
      if (((corner.pinned >> axis) & 1) && corner.position[a] == cell.wall(solid, a, true)) {
        octant |= 1u << axis;
      }
    }
    if (corner.pinned == 7) {
      cell.corners[octant] = CornerState::Boundary;
      for (unsigned axis = 0; axis < 3; ++axis) {
        touched |= 1u << edge_index(axis, octant & ~(1u << axis));
      }
      continue;
    }
    const auto axis = static_cast<unsigned>(std::countr_one(corner.pinned));
    const unsigned bit = 1u << edge_index(axis, octant & ~(1u << axis));
    if (corner.origin == FragmentCorner::Origin::Face) {
      crossed ^= bit;
    } else {
      touched |= bit;
    }
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (unsigned edge = 0; edge < kEdgeCount; ++edge) {
      if ((touched >> edge) & 1) continue;
      CornerState& a = cell.corners[lower_corner(edge)];
      CornerState& b = cell.corners[lower_corner(edge) | 1u << (edge / 4)];
      const auto follow = [&](CornerState known, CornerState& unknown) {
        if (unknown != CornerState::Unknown) return;
        if (known != CornerState::Inside && known != CornerState::Outside) return;
        const bool inside = (known == CornerState::Inside) != (((crossed >> edge) & 1) != 0);
        unknown = inside ? CornerState::Inside : CornerState::Outside;
        changed = true;
      };
      follow(a, b);
      follow(b, a);
    }
  }
}

}  // namespace spoctree
