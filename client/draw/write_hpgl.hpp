// A drawing -> HP-GL, for pen plotters.
#pragma once

#include <string>

#include "client/draw/drawing.hpp"

namespace spoctree {

/// The page's lower left corner is the plotter's origin; units of 0.025 mm, as plotters have them,
/// with no scaling. Pens: 1 silhouettes and captions, 2 creases, 3 steps, 4 hidden lines;
/// coloured inks: 1 grey, 2 green, 3 blue, 4 yellow, 5 red, 6 purple, 7 left eye, 8 right eye.
/// Hidden lines are cut into dashes here: plotters' own are of many lengths.
/// Hand it a drawing without data (LineData::None): its strokes are the longest, and in the
/// shortest order. Throws UsageError if the page is larger than the language's numbers (2^23 units,
/// 209 m), or has more than 10 million dashes.
std::string to_hpgl(const Drawing& drawing);

}  // namespace spoctree
