// A drawing -> PNG.
#pragma once

#include <string>

#include "client/draw/drawing.hpp"

namespace spoctree {

inline constexpr double kLeastDpi = 10;
inline constexpr double kLargestDpi = 2400;
/// Of either side, and of the picture.
inline constexpr double kLargestPngSide = 32'000;
inline constexpr double kLargestPngPixels = 2e8;

/// The page on white, smoothed, `dpi` pixels per inch of it. Throws UsageError if that number is
/// out of range or the picture has more pixels than the limits allow, BadInput if memory does not
/// suffice.
std::string to_png(const Drawing& drawing, double dpi);

}  // namespace spoctree
