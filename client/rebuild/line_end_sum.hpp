// Adds up line ends; what sums to zero is gone.
#pragma once

#include <algorithm>
#include <vector>

#include "client/rebuild/flat_index.hpp"
#include "client/rebuild/line_ends.hpp"

namespace spoctree {

/// Sums of LineEnd::count by line and vertex, in order of first appearance.
class LineEndSum {
 public:
  void add(std::uint32_t low, std::uint32_t high, std::uint32_t vertex, std::int32_t count) {
    if (2 * (sums_.size() + 1) > slots_.size()) grow();
    std::size_t i = start_of(low, high, vertex);
    for (; slots_[i] != 0; i = (i + 1) & (slots_.size() - 1)) {
      LineEnd& sum = sums_[slots_[i] - 1];
      if (sum.vertex == vertex && sum.low == low && sum.high == high) {
        sum.count += count;
        return;
      }
    }
    sums_.push_back({low, high, vertex, count});
    slots_[i] = static_cast<std::uint32_t>(sums_.size());
  }

  /// Calls visit(end) for every sum that is not zero, and forgets all.
  template <class Visit>
  void flush(Visit&& visit) {
    if (sums_.empty()) return;
    for (const LineEnd& sum : sums_) {
      if (sum.count != 0) visit(sum);
    }
    // Do not keep clearing a table that was large once.
    if (16 * sums_.size() < slots_.size()) slots_.resize(slots_.size() / 2);
    std::fill(slots_.begin(), slots_.end(), 0u);
    sums_.clear();
  }

 private:
  std::size_t start_of(std::uint32_t low, std::uint32_t high, std::uint32_t vertex) const {
    const std::uint64_t line = (std::uint64_t{low} << 32 | high) * 0x9e3779b97f4a7c15u;
    const std::uint64_t key = (line ^ vertex) * 0xd6e8feb86659fd93u;
    return (key ^ (key >> 32)) & (slots_.size() - 1);
  }

  void grow() {
    slots_.assign(std::max<std::size_t>(256, 2 * slots_.size()), 0u);
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      std::size_t i = start_of(sums_[k].low, sums_[k].high, sums_[k].vertex);
      while (slots_[i] != 0) i = (i + 1) & (slots_.size() - 1);
      slots_[i] = static_cast<std::uint32_t>(k + 1);
    }
  }

  std::vector<LineEnd> sums_;
  std::vector<std::uint32_t> slots_;  // 1 + index in sums_; a power of two, at most half filled
};

}  // namespace spoctree
