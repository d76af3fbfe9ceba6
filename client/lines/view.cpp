#include "client/lines/view.hpp"

#include <glm/common.hpp>

namespace spoctree {

ProjectedLine project(Vec3 a, Vec3 b, const Camera& camera) {
  ProjectedLine projected;
  projected.range = {0, 1};
  const double least = camera.least_depth();
  const double depth_a = camera.depth(a);
  const double depth_b = camera.depth(b);
  if (depth_a < least && depth_b < least) {
    projected.range.end = 0;
    return projected;
  }
  const double border = (least - depth_a) / (depth_b - depth_a);
  if (depth_a < least) projected.range.begin = border;
  if (depth_b < least) projected.range.end = border;
  projected.depth_a = std::max(depth_a, least);
  projected.depth_b = std::max(depth_b, least);
  projected.a = camera.project(depth_a < least ? a + border * (b - a) : a);
  projected.b = camera.project(depth_b < least ? a + border * (b - a) : b);
  return projected;
}

std::optional<Rectangle> extent_of_box(const NodeBox& box, const Camera& camera) {
  const Vec3 lower = box.lower;
  const Vec3 upper = box.upper;
  if (!camera.is_perspective()) {
    const Vec3 half = 0.5 * (upper - lower);
    const Vec2 middle = camera.project(0.5 * (lower + upper));
    const Vec2 reach{glm::dot(glm::abs(camera.right()), half),
                     glm::dot(glm::abs(camera.up()), half)};
    return Rectangle{middle - reach, middle + reach};
  }
  Rectangle extent;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 point{corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y,
                     corner & 4 ? upper.z : lower.z};
    if (camera.depth(point) < camera.least_depth()) return std::nullopt;
    const Vec2 at = camera.project(point);
    extent.lower = corner == 0 ? at : glm::min(extent.lower, at);
    extent.upper = corner == 0 ? at : glm::max(extent.upper, at);
  }
  return extent;
}

void project(std::span<const Vec3> corners, const Camera& camera, std::vector<Vec2>& points) {
  points.clear();
  if (!camera.is_perspective()) {
    for (const Vec3 corner : corners) points.push_back(camera.project(corner));
    return;
  }
  const double least = camera.least_depth();
  for (const Vec3 corner : corners) {
    const double depth = camera.depth(corner);
    if (depth >= least) {
      points.push_back(camera.project(corner));
      continue;
    }
    // Among the ways to the other corners are all edges; the others lie within.
    for (const Vec3 other : corners) {
      const double other_depth = camera.depth(other);
      if (other_depth < least) continue;
      points.push_back(
          camera.project(corner + (least - depth) / (other_depth - depth) * (other - corner)));
    }
  }
}

}  // namespace spoctree
