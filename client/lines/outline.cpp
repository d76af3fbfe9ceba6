#include "client/lines/outline.hpp"

#include <algorithm>
#include <cmath>

namespace spoctree {

namespace {

/// Corners are off by 2^-45 at most, a hundred times less than this fraction of the tolerance; an
/// edge longer than kShortEdge points where it should up to 1e-7.
constexpr double kStraight = 1.0 / 16;
constexpr double kShortEdge = 1e-6;

bool is_superfluous(Vec2 before, Vec2 corner, Vec2 after, double tolerance) {
  const double length = glm::distance(before, corner);
  if (length <= tolerance) return true;
  if (length > kShortEdge && glm::distance(corner, after) > kShortEdge) return false;
  const Vec2 along = after - before;
  const double span = glm::length(along);
  const Vec2 off = corner - before;
  return std::abs(along.x * off.y - along.y * off.x) <= kStraight * tolerance * span;
}

}  // namespace

void straighten(std::vector<Vec2>& polygon, double tolerance) {
  std::size_t kept = 0;
  for (const Vec2 corner : polygon) {
    while (kept > 1 && is_superfluous(polygon[kept - 2], polygon[kept - 1], corner, tolerance)) {
      --kept;
    }
    polygon[kept++] = corner;
  }
  // Round the end.
  std::size_t first = 0;
  for (bool changed = true; changed && kept - first > 2;) {
    changed = false;
    if (is_superfluous(polygon[kept - 2], polygon[kept - 1], polygon[first], tolerance)) {
      --kept;
      changed = true;
    } else if (is_superfluous(polygon[kept - 1], polygon[first], polygon[first + 1], tolerance)) {
      ++first;
      changed = true;
    }
  }
  polygon.resize(kept);
  polygon.erase(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(first));
  if (polygon.size() < 3) polygon.clear();
}

void find_outline(std::vector<Vec2>& points, double tolerance, std::vector<Vec2>& outline) {
  // Andrew's monotone chain: the lower side from left to right, then the upper one back.
  outline.clear();
  std::sort(points.begin(), points.end(),
            [](Vec2 p, Vec2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  const auto is_right_turn = [](Vec2 p, Vec2 q, Vec2 r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) <= 0;
  };
  const auto append = [&](Vec2 point, std::size_t first) {
    while (outline.size() >= first + 2 &&
           is_right_turn(outline[outline.size() - 2], outline.back(), point)) {
      outline.pop_back();
    }
    outline.push_back(point);
  };
  for (const Vec2 point : points) append(point, 0);
  const std::size_t right_end = outline.size() - 1;
  for (std::size_t k = points.size() - 1; k-- > 0;) append(points[k], right_end);
  outline.pop_back();
  straighten(outline, tolerance);
}

}  // namespace spoctree
