// A level of a tree -> the measures of the solid, as far as they can be known.
#pragma once

#include <optional>
#include <string>

#include "common/tree/octree.hpp"
#include "common/tree/piece_bounds.hpp"

namespace spoctree {

/// A number that is not less than `lower` and not more than `upper`.
struct Bounds {
  double lower = 0;
  double upper = 0;
};

/// Model units throughout.
struct Measures {
  std::uint32_t level = 0;
  /// True if the tree is complete at this level: then all bounds are equal, and what they enclose
  /// is known up to the rounding of doubles (about 1e-12 of the universe cube).
  bool is_exact = false;
  Bounds volume;
  Bounds area;
  std::optional<Box>
      inner_box;  ///< the solid's bounding box contains it; nothing: nothing is known
  std::optional<Box> outer_box;  ///< contains the solid; nothing: the solid is empty
  /// Connected pieces of material, and of emptiness enclosed by it; nothing before the last level.
  /// What touches in edges or vertices only is not connected: two cubes with an edge in common are
  /// two components, and two rooms with one are two cavities.
  std::optional<std::uint32_t> components;
  std::optional<std::uint32_t> cavities;
};

/// What the levels 0..`level` say. Volumes and boxes are computed from the tree. Of the area, the
/// stream's statement is taken (LevelStatement), and for the lower bound what a ball of the certain
/// volume has, where that is more. At the last level everything comes from the rebuilt boundary.
/// The price of bound_pieces, or at the last level of rebuild_surface. REQUIRES: a valid tree, and
/// `level` is one of its levels.
Measures measure(const Octree& tree, std::uint32_t level);

/// For people: a line per measure. `units` of the model may be empty.
std::string to_table(const Measures& measures, const std::string& units);
/// One JSON object.
std::string to_json(const Measures& measures, const std::string& model, const std::string& units);

}  // namespace spoctree
