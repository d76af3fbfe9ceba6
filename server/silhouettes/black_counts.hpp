// A square of pixels -> how many of them are black.
#pragma once

#include <cstdint>
#include <vector>

#include "server/silhouettes/mask.hpp"

namespace spoctree {

/// The sums of all rectangles that begin in the first pixel, so that any rectangle's is a sum of
/// four. O(pixels) to make.
class BlackCounts {
 public:
  explicit BlackCounts(const Mask& mask);

  /// Black pixels in columns [left, left + width) and rows [top, top + height).
  std::uint32_t count(int left, int top, int width, int height) const {
    return at(left + width, top + height) - at(left, top + height) - at(left + width, top) +
           at(left, top);
  }

 private:
  std::uint32_t at(int column, int row) const {
    return sums_[static_cast<std::size_t>(row) * stride_ + static_cast<std::size_t>(column)];
  }

  std::size_t stride_;
  std::vector<std::uint32_t> sums_;
};

}  // namespace spoctree
