// A line of space -> the part of it that a frame shows, on the picture.
#pragma once

#include <optional>

#include "client/lines/camera.hpp"

namespace spoctree {

struct ClippedLine {
  Vec2 a{0.0};
  Vec2 b{0.0};
};

/// The picture of the segment a b as far as it lies in the frame and, in a perspective, in front of
/// the viewer; nothing if none of it does, or not more than a point. Picture coordinates.
std::optional<ClippedLine> clip_line(const Camera& camera, const Rectangle& frame, Vec3 a, Vec3 b);

}  // namespace spoctree
