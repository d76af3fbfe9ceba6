#include "client/cells/sight_mask.hpp"

#include <algorithm>
#include <cmath>

namespace spoctree {

SightPoint sight_point(Vec3 point, const Camera& camera) {
  if (!camera.is_perspective()) {
    return {glm::dot(camera.right(), point), glm::dot(camera.up(), point), 1};
  }
  const Vec3 from_eye = point - camera.eye();
  return {camera.focal_length() * glm::dot(camera.right(), from_eye),
          camera.focal_length() * glm::dot(camera.up(), from_eye),
          -glm::dot(camera.toward_viewer(), from_eye)};
}

SightLine sight_line(const SightPoint& from, const SightPoint& to) {
  const Vec3 line = glm::cross(Vec3{from.x, from.y, from.w}, Vec3{to.x, to.y, to.w});
  const double length = std::hypot(line.x, line.y);
  if (!(length > 0)) return {0, 0, 1};
  return {line.x / length, line.y / length, line.z / length};
}

SightMask mask_of(const Rectangle& frame) {
  const Vec2 lower = frame.lower;
  const Vec2 upper = frame.upper;
  SightMask mask;
  mask.corners = {{lower, {0, 1, -lower.y}},
                  {{upper.x, lower.y}, {-1, 0, upper.x}},
                  {upper, {0, -1, upper.y}},
                  {{lower.x, upper.y}, {1, 0, -lower.x}}};
  return mask;
}

double area_of(std::span<const SightMask::Corner> mask) {
  double twice_area = 0;
  for (std::size_t k = 1; k + 1 < mask.size(); ++k) {
    const Vec2 p = mask[k].at - mask[0].at;
    const Vec2 q = mask[k + 1].at - mask[0].at;
    twice_area += p.x * q.y - p.y * q.x;
  }
  return 0.5 * twice_area;
}

bool is_too_thin(std::span<const SightMask::Corner> mask, double thinnest) {
  if (mask.size() < 3) return true;
  double around = 0;
  for (std::size_t k = 0; k < mask.size(); ++k) {
    around += glm::distance(mask[k].at, mask[k + 1 == mask.size() ? 0 : k + 1].at);
  }
  // A strip of length l and width w has the area l w, and is 2 l around.
  return !(2 * area_of(mask) > thinnest * around);
}

/// Of `polygon_`. Corners that are cut off become one at either end of the cut.
void MaskClipper::cut(const SightLine& line) {
  cut_.clear();
  const std::size_t count = polygon_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const SightOpening::Corner& corner = polygon_[k];
    const SightOpening::Corner& next = polygon_[k + 1 == count ? 0 : k + 1];
    const double value = line(corner.at);
    const double next_value = line(next.at);
    if (value >= 0) cut_.push_back(corner);
    if ((value >= 0) == (next_value >= 0)) continue;
    const double t = value / (value - next_value);
    const SightPoint crossing{corner.at.x + t * (next.at.x - corner.at.x),
                              corner.at.y + t * (next.at.y - corner.at.y),
                              corner.at.w + t * (next.at.w - corner.at.w)};
    cut_.push_back({crossing, value >= 0 ? line : corner.line});
  }
  std::swap(polygon_, cut_);
}

bool MaskClipper::clip(std::span<const SightMask::Corner> mask, const SightOpening& opening,
                       double thinnest, SightMask& result) {
  // Most often all of the mask is within the opening, or nothing of it.
  bool is_within = true;
  for (const SightOpening::Corner& corner : opening.corners) {
    bool any_inside = false;
    for (const SightMask::Corner& point : mask) {
      if (corner.line(point.at) >= 0) {
        any_inside = true;
      } else {
        is_within = false;
      }
    }
    if (!any_inside) return false;
  }
  if (is_within) {
    result.corners.assign(mask.begin(), mask.end());
    return true;
  }
  polygon_.assign(opening.corners.begin(), opening.corners.end());
  for (const SightMask::Corner& corner : mask) {
    cut(corner.line);
    if (polygon_.size() < 3) return false;
  }
  result.corners.clear();
  for (const SightOpening::Corner& corner : polygon_) {
    if (!(corner.at.w > 0)) return false;  // the eye lies in the opening's plane, up to rounding
    result.corners.push_back({{corner.at.x / corner.at.w, corner.at.y / corner.at.w}, corner.line});
  }
  return !is_too_thin(result.corners, thinnest);
}

bool MaskClipper::clip(SightMask& mask, const SightLine& line, double thinnest) {
  polygon_.clear();
  for (const SightMask::Corner& corner : mask.corners) {
    polygon_.push_back({{corner.at.x, corner.at.y, 1}, corner.line});
  }
  cut(line);
  mask.corners.clear();
  for (const SightOpening::Corner& corner : polygon_) {
    mask.corners.push_back({{corner.at.x, corner.at.y}, corner.line});
  }
  return !is_too_thin(mask.corners, thinnest);
}

void clip_line(const SightPoint& a, const SightPoint& b, std::span<const SightMask::Corner> mask,
               double tolerance, Interval& part) {
  for (const SightMask::Corner& corner : mask) {
    const double at_a = corner.line(a) + tolerance * a.w;
    const double at_b = corner.line(b) + tolerance * b.w;
    const double at_begin = at_a + part.begin * (at_b - at_a);
    const double at_end = at_a + part.end * (at_b - at_a);
    if (at_begin < 0 && at_end < 0) {
      part.end = part.begin;
      return;
    }
    const double crossing = at_a / (at_a - at_b);
    if (at_begin < 0) part.begin = std::min(std::max(part.begin, crossing), part.end);
    if (at_end < 0) part.end = std::max(std::min(part.end, crossing), part.begin);
  }
}

}  // namespace spoctree
