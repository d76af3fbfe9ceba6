#include "server/silhouettes/render_silhouette.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace spoctree {

namespace {

constexpr std::int64_t kPixel = 1 << 16;
constexpr std::int64_t kHalfPixel = kPixel / 2;

struct Point {
  std::int64_t x;
  std::int64_t y;
};

/// REQUIRES: d > 0.
std::int64_t floor_of_quotient(std::int64_t n, std::int64_t d) {
  return n >= 0 ? n / d : -((-n + d - 1) / d);
}
std::int64_t ceiling_of_quotient(std::int64_t n, std::int64_t d) {
  return -floor_of_quotient(-n, d);
}

/// The columns whose centres a triangle covers in one row.
struct Span {
  std::int64_t first;
  std::int64_t last;

  /// x = n / d is covered.
  void include(std::int64_t n, std::int64_t d) {
    first = std::min(first, ceiling_of_quotient(n - kHalfPixel * d, kPixel * d));
    last = std::max(last, floor_of_quotient(n - kHalfPixel * d, kPixel * d));
  }
};

void include_edge(const Point& p, const Point& q, std::int64_t y, Span& span) {
  const Point& low = p.y <= q.y ? p : q;
  const Point& high = p.y <= q.y ? q : p;
  if (y < low.y || y > high.y) return;
  if (low.y == high.y) {
    span.include(low.x, 1);
    span.include(high.x, 1);
    return;
  }
  const std::int64_t d = high.y - low.y;
  span.include(low.x * d + (y - low.y) * (high.x - low.x), d);
}

void fill(Mask& mask, const Point& a, const Point& b, const Point& c) {
  const auto [y_min, y_max] = std::minmax({a.y, b.y, c.y});
  const std::int64_t first_row =
      std::max<std::int64_t>(0, ceiling_of_quotient(y_min - kHalfPixel, kPixel));
  const std::int64_t last_row =
      std::min<std::int64_t>(mask.height - 1, floor_of_quotient(y_max - kHalfPixel, kPixel));
  for (std::int64_t row = first_row; row <= last_row; ++row) {
    const std::int64_t y = row * kPixel + kHalfPixel;
    Span span{mask.width, -1};
    include_edge(a, b, y, span);
    include_edge(b, c, y, span);
    include_edge(c, a, y, span);
    const std::int64_t last = std::min<std::int64_t>(span.last, mask.width - 1);
    for (std::int64_t column = std::max<std::int64_t>(span.first, 0); column <= last; ++column)
      mask.at(static_cast<int>(column), static_cast<int>(row)) = 1;
  }
}

}  // namespace

Mask render_silhouette(const View& view, std::span<const glm::dvec3> points,
                       std::span<const std::array<std::uint32_t, 3>> triangles, int width,
                       int height) {
  std::vector<Point> projected;
  projected.reserve(points.size());
  for (const glm::dvec3& p : points) {
    projected.push_back({std::llround(view.across(p) * width * static_cast<double>(kPixel)),
                         std::llround(view.down(p) * height * static_cast<double>(kPixel))});
  }
  Mask mask(width, height);
  for (const auto& [a, b, c] : triangles) fill(mask, projected[a], projected[b], projected[c]);
  return mask;
}

}  // namespace spoctree
