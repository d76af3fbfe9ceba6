// The planes of a node's ancestors, kept as marks while the nodes of a level go by in order.
#pragma once

#include <cstdint>
#include <vector>

#include "common/tree/octree.hpp"

namespace spoctree {

/// Answers whether a plane stands already in the node that is being read or in one of its
/// ancestors. Going through a level costs at most as much as the levels above are large.
class AncestorPlanes {
 public:
  /// The level below the last one of `tree` comes next. Call once per level, from the root on.
  void begin_level(const Octree& tree);

  /// Entry `node` of that level is read next. REQUIRES: the marks of the node before are cleared.
  void move_to(const Octree& tree, std::uint32_t node);

  /// Marks a plane of the node itself; false if it is marked already.
  bool mark(std::uint32_t plane);
  void clear(std::uint32_t plane) { marked_[plane] = false; }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  std::vector<std::vector<std::uint32_t>> greys_;  ///< per level, its GREY nodes
  std::vector<std::uint32_t> path_;  ///< per level, the ancestor whose planes are marked
  std::vector<bool> marked_;
};

}  // namespace spoctree
