// A silhouette: which pixels of a view show the object.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace spoctree {

/// Pictures larger than this, in either direction, are refused.
inline constexpr int kMostMaskPixels = 4096;

/// Pixels row by row from the top, each row from the left: 1 the object, 0 free space.
struct Mask {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;

  Mask() = default;
  Mask(int columns, int rows)
      : width(columns),
        height(rows),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  std::uint8_t& at(int column, int row) { return pixels[index(column, row)]; }
  std::uint8_t at(int column, int row) const { return pixels[index(column, row)]; }

  bool has_object() const { return std::find(pixels.begin(), pixels.end(), 1) != pixels.end(); }

  bool operator==(const Mask&) const = default;

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
};

/// The mask with the eight neighbours of every object pixel made object, too (section III-B).
Mask grow(const Mask& mask);

/// The mask as a square of 2^bits by 2^bits: every cell has the colour of the pixel in which its
/// middle lies (a middle on the border of two pixels: the right or lower one). A square of that
/// size remains as it is; where 2^bits is at least width and height, no pixel is lost.
/// REQUIRES: a mask with pixels.
Mask resample(const Mask& mask, int bits);

/// The smallest number with 2^bits at least `pixels`.
int bits_for(int pixels);

}  // namespace spoctree
