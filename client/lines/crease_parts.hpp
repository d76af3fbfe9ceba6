// Creases -> which parts of them touch which leaf: what no view changes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/lines/crease.hpp"
#include "common/base/progress_meter.hpp"
#include "common/base/small_count.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

/// A part of a line from `begin` to `end`, as parameters.
struct Interval {
  double begin = 0;
  double end = 0;
};

/// A part of a crease: the points a + t (b - a), t in `interval`.
struct CreasePart {
  std::uint32_t crease = 0;
  Interval interval;
};

/// For every leaf (and every GREY node of the level looked at) the parts of creases that touch its
/// cube: those inside, and those on its walls, which others touch as well.
class CreaseParts {
 public:
  /// What is nearer to a cube than `tolerance` (universe units) touches it. Time and memory
  /// O(creases * cubes that each touches); cubes that no crease touches are not visited. Throws
  /// BadInput if there are more than `most` parts, or what `progress` throws.
  CreaseParts(const Octree& tree, std::uint32_t level, std::span<const Crease> creases,
              double tolerance, const ProgressShare& progress = {},
              std::size_t most = kMostIn32Bits);

  std::span<const CreasePart> of(const NodeAddress& leaf) const {
    const Range range = ranges_[leaf.level][leaf.index];
    return {parts_.data() + range.first, range.count};
  }

 private:
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  class Distributor;

  std::vector<std::vector<Range>> ranges_;  // by level and index
  std::vector<CreasePart> parts_;
};

}  // namespace spoctree
