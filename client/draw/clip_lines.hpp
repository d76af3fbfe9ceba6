// Lines of space -> those parts of them that a frame shows.
#pragma once

#include "client/lines/camera.hpp"
#include "client/lines/visible_line.hpp"

namespace spoctree {

/// What of the lines lies in the frame and, in a perspective, in front of the viewer; the order is
/// kept. Lines on the border of the frame stay, up to 1e-9 of its size. Linear.
VisibleLines clip_lines(const VisibleLines& lines, const Camera& camera, const Rectangle& frame);

}  // namespace spoctree
