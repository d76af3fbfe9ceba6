// What a picture file shows, before it is decided which of it is the object.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "server/silhouettes/mask.hpp"

namespace spoctree {

/// One pixel, 0 to Picture::white.
struct Pixel {
  std::uint16_t brightness = 0;  ///< in grey, as the eye weighs the colours
  std::uint16_t strongest = 0;   ///< of its colours, the strongest; of grey, the brightness
  std::uint16_t weakest = 0;
  bool is_transparent = false;  ///< by half or more

  bool operator==(const Pixel&) const = default;
};

struct Picture {
  int width = 0;
  int height = 0;
  int white = 255;
  std::vector<Pixel> pixels;  ///< in the order of Mask::pixels
};

/// A mask, and what the user should know of how it was found; mostly nothing.
struct MaskReading {
  Mask mask;
  std::string remark;
};

/// Decides what of a picture is the object:
/// - what is opaque, where a part of the picture is transparent;
/// - else what is bright, at least half of white;
/// - where nothing is, what has a colour that is at least half as strong as can be, if there is a
///   ground without one;
/// - and where nothing has one, what is not black, if all of it is of one brightness (a picture of
///   labels).
/// A remark says so where it is not what is bright, and that nothing is the object where all pixels
/// are black. Throws BadInput, with the brightness found, where all this leaves doubt: for a dark
/// picture of several greys, for one of bright and of dark colours, and for one that is transparent
/// all over. Linear in the pixels. REQUIRES: pixels.
MaskReading find_object(const Picture& picture, std::string_view name);

}  // namespace spoctree
