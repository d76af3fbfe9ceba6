#include "client/draw/clip_line.hpp"

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

}  // namespace

std::optional<ClippedLine> clip_line(const Camera& camera, const Rectangle& frame, Vec3 a, Vec3 b) {
  const auto inside_a = insides(camera, frame, a);
  const auto inside_b = insides(camera, frame, b);
  double begin = 0;
  double end = 1;
  for (std::size_t side = 0; side < inside_a.size(); ++side) {
    const double at_a = inside_a[side];
    const double at_b = inside_b[side];
    if (at_a < 0 && at_b < 0) return std::nullopt;
    if (at_a < 0) begin = std::max(begin, at_a / (at_a - at_b));
    if (at_b < 0) end = std::min(end, at_a / (at_a - at_b));
  }
  if (begin >= end) return std::nullopt;
  const auto project = [&](double t) {
    return camera.project(t == 0 ? a : (t == 1 ? b : a + t * (b - a)));
  };
  const ClippedLine line{project(begin), project(end)};
  if (line.a == line.b) return std::nullopt;
  return line;
}

}  // namespace spoctree
