#include "client/draw/cut_dashes.hpp"

#include <cmath>

namespace spoctree {

std::vector<std::vector<Vec2>> cut_dashes(std::span<const Vec2> points, double before_mm,
                                          double dash_mm, double gap_mm) {
  const double phase = std::fmod(before_mm, dash_mm + gap_mm);
  bool is_dash = phase < dash_mm;
  double left = (is_dash ? dash_mm : dash_mm + gap_mm) - phase;  // of the dash or gap
  std::vector<std::vector<Vec2>> dashes;
  if (is_dash) dashes.push_back({points.front()});
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec2 begin = points[k - 1];
    const double length = glm::distance(begin, points[k]);
    double at = 0;
    while (at + left < length) {
      at += left;
      const Vec2 point = begin + (points[k] - begin) * (at / length);
      if (is_dash) {
        dashes.back().push_back(point);
      } else {
        dashes.push_back({point});
      }
      is_dash = !is_dash;
      left = is_dash ? dash_mm : gap_mm;
    }
    left -= length - at;
    if (is_dash) dashes.back().push_back(points[k]);
  }
  return dashes;
}

}  // namespace spoctree
