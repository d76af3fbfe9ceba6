#include "server/silhouettes/mask.hpp"

#include <algorithm>

namespace spoctree {

Mask grow(const Mask& mask) {
  Mask grown(mask.width, mask.height);
  for (int row = 0; row < mask.height; ++row) {
    for (int column = 0; column < mask.width; ++column) {
      if (mask.at(column, row) == 0) continue;
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, mask.height - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, mask.width - 1); ++x)
          grown.at(x, y) = 1;
      }
    }
  }
  return grown;
}

Mask resample(const Mask& mask, int bits) {
  const int side = 1 << bits;
  if (mask.width == side && mask.height == side) return mask;
  // The pixel that contains (i + 1/2) / side of the whole.
  const auto pixel_of = [side](int i, int pixels) {
    return static_cast<int>((2 * std::int64_t{i} + 1) * pixels / (2 * std::int64_t{side}));
  };
  Mask square(side, side);
  for (int row = 0; row < side; ++row) {
    const int y = pixel_of(row, mask.height);
    for (int column = 0; column < side; ++column)
      square.at(column, row) = mask.at(pixel_of(column, mask.width), y);
  }
  return square;
}

int bits_for(int pixels) {
  int bits = 0;
  while ((1 << bits) < pixels) ++bits;
  return bits;
}

}  // namespace spoctree
