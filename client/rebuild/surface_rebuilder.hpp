// T_0, T_1, ..., as they arrive -> their boundaries, without finding again what has not changed.
#pragma once

#include <cstdint>

#include "client/rebuild/carriers.hpp"
#include "client/rebuild/chain.hpp"
#include "client/rebuild/corners.hpp"
#include "client/rebuild/face_sides.hpp"
#include "client/rebuild/surface.hpp"
#include "common/base/progress_meter.hpp"

namespace spoctree {

/// Rebuilds a growing tree. T_k+1 differs from T_k where GREY nodes of level k have become their
/// children, so the corners of leaves are found once and kept: that is most of the work.
class SurfaceRebuilder {
 public:
  /// The same as rebuild_surface(tree, level), to the byte, whatever was rebuilt before.
  /// REQUIRES: a valid tree, which begins with the levels that were gone on to before; none of
  /// these but the last. Throws as rebuild_surface does. In parallel; time O(nodes that are new +
  /// boundary) as a rule. What `progress` throws is thrown on, and ends this rebuilder's use.
  Surface rebuild(const Octree& tree, std::uint32_t level, const ProgressShare& progress = {});

  /// See LevelCorners::cells_visited.
  std::uint64_t cells_visited() const { return corners_.cells_visited(); }

 private:
  void advance(const Octree& tree, std::uint32_t level, const ProgressShare& progress);
  void settle(Chain& chain, VertexWelder& welder, const ProgressShare& progress);

  std::uint32_t level_count_ = 0;  // that were gone on to
  std::uint32_t plane_count_ = 0;  // of the planes that these refer to
  Carriers carriers_;
  FaceSides sides_;
  LevelCorners corners_;
};

}  // namespace spoctree
