#include "client/lines/outline.hpp"

#include <algorithm>

namespace spoctree {

void find_outline(std::vector<Vec2>& points, std::vector<Vec2>& outline) {
  // Andrew's monotone chain: the lower side from left to right, then the upper one back.
  const auto is_before = [](Vec2 p, Vec2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); };
  if (points.size() <= 24) {
    Vec2* const p = points.data();
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Vec2 point = p[k];
      std::size_t at = k;
      for (; at > 0 && is_before(point, p[at - 1]); --at) p[at] = p[at - 1];
      p[at] = point;
    }
  } else {
    std::sort(points.begin(), points.end(), is_before);
  }
  const auto is_right_turn = [](Vec2 p, Vec2 q, Vec2 r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) <= 0;
  };
  outline.resize(2 * points.size());
  Vec2* const corners = outline.data();
  std::size_t count = 0;
  const auto append = [&](Vec2 point, std::size_t first) {
    while (count >= first + 2 && is_right_turn(corners[count - 2], corners[count - 1], point)) {
      --count;
    }
    corners[count++] = point;
  };
  for (const Vec2 point : points) append(point, 0);
  const std::size_t right_end = count - 1;
  for (std::size_t k = points.size() - 1; k-- > 0;) append(points[k], right_end);
  // The last one is the first one again.
  outline.resize(count > 3 ? count - 1 : 0);
}

}  // namespace spoctree
