// A stroke -> its dashes, for what has no dashes of its own to be trusted.
#pragma once

#include <span>
#include <vector>

#include "client/lines/camera.hpp"

namespace spoctree {

/// What of the points' run is drawn: dashes of `dash_mm` with gaps of `gap_mm`, `before_mm` of
/// which had been drawn before its beginning (Stroke::dashes_before_mm). Dashes go round corners.
/// O(points + dashes). REQUIRES: dash and gap greater than 0.
std::vector<std::vector<Vec2>> cut_dashes(std::span<const Vec2> points, double before_mm,
                                          double dash_mm, double gap_mm);

}  // namespace spoctree
