#include "client/draw/clip_lines.hpp"

#include <algorithm>
#include <array>

namespace spoctree {

namespace {

/// How far inside each side of the view volume a point is, in any unit that is linear in space;
/// negative outside. `slack` keeps what stands off the frame by rounding.
std::array<double, 5> insides(const Camera& camera, const Rectangle& frame, Vec3 point) {
  const double slack =
      1e-9 * std::max(frame.upper.x - frame.lower.x, frame.upper.y - frame.lower.y);
  double x = glm::dot(camera.right(), point);
  double y = glm::dot(camera.up(), point);
  double unit = 1;
  double before_viewer = 1;
  if (camera.is_perspective()) {
    const double to_picture = camera.focal_length();
    x = to_picture * glm::dot(camera.right(), point - camera.eye());
    y = to_picture * glm::dot(camera.up(), point - camera.eye());
    unit = camera.depth(point);
    before_viewer = unit - 2 * camera.least_depth();
  }
  return {x - (frame.lower.x - slack) * unit, (frame.upper.x + slack) * unit - x,
          y - (frame.lower.y - slack) * unit, (frame.upper.y + slack) * unit - y, before_viewer};
}

/// Shortens the line; false if none of it, or no more than a point, is left.
bool clip(VisibleLine& line, const Camera& camera, const Rectangle& frame) {
  const auto inside_a = insides(camera, frame, line.a);
  const auto inside_b = insides(camera, frame, line.b);
  double begin = 0;
  double end = 1;
  for (std::size_t side = 0; side < inside_a.size(); ++side) {
    const double at_a = inside_a[side];
    const double at_b = inside_b[side];
    if (at_a < 0 && at_b < 0) return false;
    if (at_a < 0) begin = std::max(begin, at_a / (at_a - at_b));
    if (at_b < 0) end = std::min(end, at_a / (at_a - at_b));
  }
  if (begin > 0 || end < 1) line = cut(line, begin, end);
  return begin < end && camera.project(line.a) != camera.project(line.b);
}

}  // namespace

VisibleLines clip_lines(const VisibleLines& lines, const Camera& camera, const Rectangle& frame) {
  VisibleLines clipped;
  clipped.reserve(lines.size());
  for (VisibleLine line : lines) {
    if (clip(line, camera, frame)) clipped.push_back(line);
  }
  return clipped;
}

}  // namespace spoctree
