// Words -> strokes: letters as a plotter draws them, so that captions are the same in every format
// and need no fonts.
#pragma once

#include <string_view>
#include <vector>

#include "client/lines/camera.hpp"

namespace spoctree {

/// The strokes of `text`, its letters `height` high, from `at` on to the right; `at` is the lower
/// left corner of the first letter, y goes downwards. Small letters become capitals; what is
/// neither a letter, a digit nor one of "-./:," is left blank.
std::vector<std::vector<Vec2>> letter(std::string_view text, Vec2 at, double height);

/// How much room they take.
double lettering_width(std::string_view text, double height);

}  // namespace spoctree
