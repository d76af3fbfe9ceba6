// Lines -> chains of lines that meet end to end in the picture: the pen stays down, and dashes run
// on as a draughtsman draws them, instead of beginning anew at every edge of a curved face.
#pragma once

#include "client/lines/camera.hpp"
#include "client/lines/visible_line.hpp"

namespace spoctree {

/// Orders and turns the lines so that each begins, as often as can be, where the one before it
/// ends: up to `tolerance`, picture units. Where several meet, the straightest ways through the
/// point go on. Chains come in a short pen order. Deterministic, about O(n log n).
/// REQUIRES: lines of one pen, in front of the viewer.
VisibleLines in_chains(const VisibleLines& lines, const Camera& camera, double tolerance);

}  // namespace spoctree
