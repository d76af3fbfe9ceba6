// Adds up corners of solids by the planes that meet in them; what sums to zero is gone.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "client/rebuild/flat_index.hpp"

namespace spoctree {

/// A point in which three planes meet, as numbers in ascending order (Carriers::number_of), and how
/// often the boundary has a corner there: `count` is the sum of +1 for every convex corner whose
/// planes, in this order, are seen counter-clockwise from outside, and -1 if clockwise. The
/// corner's three edges have a say on the three lines of two of the planes, always by this same
/// number (see line_ends.hpp).
struct CornerCount {
  std::uint32_t planes[3];
  std::int32_t count;
};

/// Sums of CornerCount::count by planes, in order of first appearance.
class CornerSum {
 public:
  /// `a`, `b` and `c` in any order; `count` holds for this one.
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::int32_t count) {
    // Without branches: no processor foresees them.
    const bool swaps_first = a > b;
    const std::uint32_t low = std::min(a, b);
    const std::uint32_t high = std::max(a, b);
    const bool swaps_last = high > c;
    const std::uint32_t middle = std::min(high, c);
    const bool swaps_again = low > middle;
    const std::int32_t is_odd = swaps_first ^ swaps_last ^ swaps_again;
    add_sorted({{std::min(low, middle), std::max(low, middle), std::max(high, c)},
                (count ^ -is_odd) + is_odd});
  }

  void add_sorted(const CornerCount& corner) {
    if (2 * (sums_.size() + 1) > slots_.size()) grow();
    std::size_t i = start_of(corner);
    for (; slots_[i] != 0; i = (i + 1) & (slots_.size() - 1)) {
      CornerCount& sum = sums_[slots_[i] - 1];
      if (sum.planes[2] == corner.planes[2] && sum.planes[1] == corner.planes[1] &&
          sum.planes[0] == corner.planes[0]) {
        sum.count += corner.count;
        return;
      }
    }
    sums_.push_back(corner);
    slots_[i] = static_cast<std::uint32_t>(sums_.size());
  }

  /// Calls visit(corner) for every sum that is not zero, and forgets all.
  template <class Visit>
  void flush(Visit&& visit) {
    for (const CornerCount& sum : sums_) {
      if (sum.count != 0) visit(sum);
    }
    std::fill(slots_.begin(), slots_.end(), 0u);
    sums_.clear();
  }

 private:
  std::size_t start_of(const CornerCount& corner) const {
    const std::uint64_t last = corner.planes[2] * 0x9e3779b97f4a7c15u;
    const std::uint64_t key = std::uint64_t{corner.planes[0]} << 32 | corner.planes[1];
    return mix_bits(key ^ last) & (slots_.size() - 1);
  }

  void grow() {
    slots_.assign(std::max<std::size_t>(1024, 2 * slots_.size()), 0u);
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      std::size_t i = start_of(sums_[k]);
      while (slots_[i] != 0) i = (i + 1) & (slots_.size() - 1);
      slots_[i] = static_cast<std::uint32_t>(k + 1);
    }
  }

  std::vector<CornerCount> sums_;
  std::vector<std::uint32_t> slots_;  // 1 + index in sums_; a power of two, at most half filled
};

}  // namespace spoctree
