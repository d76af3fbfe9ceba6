#include "server/solid/fit_plane.hpp"

namespace spoctree {

namespace {

constexpr long double kPerGridStep = 0x1p-52L;

}  // namespace

FittedPlane fit_plane(const FlatSurface& surface, std::span<const std::uint32_t> triangles) {
  FittedPlane fitted;
  std::uint32_t largest = triangles[0];
  long double sum[3] = {0, 0, 0};
  for (const std::uint32_t t : triangles) {
    const Corners& c = surface.triangles[t];
    const AreaVector area =
        area_vector(surface.points[c[0]], surface.points[c[1]], surface.points[c[2]]);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += static_cast<long double>(area[i]);
    if (surface.areas[t] > surface.areas[largest]) largest = t;
  }
  const long double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  fitted.area = static_cast<double>(length * 0.5L * 0x1p-104L);

  double whole = 0;
  double like_largest = 0;
  for (const std::uint32_t t : triangles) {
    whole += surface.areas[t];
    if (surface.plane_numbers[t] == surface.plane_numbers[largest]) {
      like_largest += surface.areas[t];
    } else {
      fitted.is_exact = false;
    }
  }
  if (fitted.is_exact || length == 0 || 2 * like_largest >= whole) {
    fitted.plane = surface.planes[largest];
    return fitted;
  }

  fitted.plane.normal = round_direction(sum[0], sum[1], sum[2]);
  // Heights are summed as differences from one of them: the sum keeps its digits.
  const Int128 base = fitted.plane.height(surface.points[surface.triangles[triangles.front()][0]]);
  long double above_base = 0;
  for (const std::uint32_t t : triangles) {
    long double heights = 0;
    for (const std::uint32_t v : surface.triangles[t]) {
      heights += static_cast<long double>(fitted.plane.height(surface.points[v]) - base);
    }
    above_base += static_cast<long double>(surface.areas[t]) * heights / 3;
  }
  above_base /= static_cast<long double>(whole);
  const Int128 height = base + static_cast<Int128>(above_base);
  fitted.plane.offset = std::llrint(static_cast<long double>(height) * kPerGridStep);
  return fitted;
}

}  // namespace spoctree
