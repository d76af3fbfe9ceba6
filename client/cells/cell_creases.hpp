// Creases -> those on the boundary of each empty cell: what no view changes.
#pragma once

#include <span>
#include <vector>

#include "client/cells/empty_space.hpp"

namespace spoctree {

/// For every cell the parts of creases that touch it. Around each crease there is empty space, so
/// that each part is in the list of one cell at least.
class CellCreases {
 public:
  /// What is nearer to a cell than `reach` (universe units) touches it. O(creases * splits that
  /// each touches). Throws BadInput if there are too many parts, or what `progress` throws.
  CellCreases(const EmptySpace& space, std::span<const Crease> creases, double reach,
              const ProgressShare& progress = {});

  std::span<const CreasePart> of(std::uint32_t cell) const {
    return {parts_.data() + begin_[cell], begin_[cell + 1] - begin_[cell]};
  }

 private:
  std::vector<std::uint32_t> begin_;  // by cell
  std::vector<CreasePart> parts_;
};

}  // namespace spoctree
