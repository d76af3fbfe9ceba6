// Lines as they were found -> as they should be drawn. All throw what their `progress` throws.
#pragma once

#include "client/lines/camera.hpp"
#include "client/lines/visible_line.hpp"
#include "common/base/progress_meter.hpp"

namespace spoctree {

/// Joins lines of one kind that continue each other straight on into one line. Joints stand off the
/// result by less than `tolerance` (universe units). O(n log n).
VisibleLines join_lines(const VisibleLines& lines, double tolerance,
                        const ProgressShare& progress = {});

/// Where lines lie on each other in the picture (up to `tolerance`, picture units), leaves only
/// one: a visible line rather than a hidden one, a silhouette rather than a crease, else that whose
/// middle is nearer. O(n) if lines are spread over the picture, however many lie on each other.
/// REQUIRES: all lines are in front of the viewer.
VisibleLines remove_overlaps(VisibleLines lines, const Camera& camera, double tolerance,
                             const ProgressShare& progress = {});

/// For ways between ends 2 k and 2 k + 1: the ends at which a pen should begin them, in an order
/// that makes short ways between them, always on to the nearest end. About O(n log n).
std::vector<std::uint32_t> pen_order(const std::vector<Vec2>& ends);

/// Orders and turns lines so that a pen that draws each from `a` to `b` makes short ways between
/// them: hidden lines first, then creases, then silhouettes; within these always on to the nearest
/// end of a line not drawn yet. Deterministic. About O(n log n).
VisibleLines in_pen_order(VisibleLines lines, const Camera& camera,
                          const ProgressShare& progress = {});

}  // namespace spoctree
