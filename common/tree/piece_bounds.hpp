// How much material a level has for certain and at most, and how far it reaches: from the tree
// alone, with bounds that hold whatever was rounded.
#pragma once

#include <optional>

#include "common/tree/octree.hpp"

namespace spoctree {

struct Box {
  Vec3 lower{0.0};
  Vec3 upper{0.0};
};

/// Bounds on the solid in universe coordinates. "Certain" is the material of the leaves.
struct PieceBounds {
  double inner_volume = 0;  ///< not more than the solid's
  double outer_volume = 0;  ///< not less than the solid's
  /// The solid's bounding box contains it; nothing where no material is certain.
  std::optional<Box> inner_box;
  /// Contains the solid: the box of T_level. Nothing where T_level is empty.
  std::optional<Box> outer_box;
};

/// The bounds that levels 0..`level` (beyond the last one: all) give. They are nested from level to
/// level up to rounding, at most about 1e-11 for volumes. The price of walk_pieces: O(nodes), each
/// a few clips. REQUIRES: a valid tree with at least one level.
PieceBounds bound_pieces(const Octree& tree, std::uint32_t level = static_cast<std::uint32_t>(-1));

}  // namespace spoctree
