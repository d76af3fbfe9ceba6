// Two drawings of one view -> what one has and the other has not.
#pragma once

#include <string>
#include <vector>

#include "client/lines/camera.hpp"
#include "client/lines/visible_line.hpp"

namespace spoctree {

/// Lengths are lengths in the picture, in universe units.
struct DrawingDifference {
  double length = 0;       ///< of all lines of the first drawing
  double only_first = 0;   ///< drawn in the first one, nowhere near in the other
  double only_second = 0;  ///< the other way round
  /// The longest of these parts, in words.
  std::vector<std::string> faults;
};

/// Within `frame`. Lines nearer to each other than `tolerance` in the picture are the same, and
/// shorter parts than this do not count.
DrawingDifference compare_drawings(const VisibleLines& first, const VisibleLines& second,
                                   const Camera& camera, const Rectangle& frame, double tolerance);

}  // namespace spoctree
