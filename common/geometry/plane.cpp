#include "common/geometry/plane.hpp"

#include <glm/geometric.hpp>

namespace spoctree {

namespace {
bool on_grid(double value, double limit) {
  const double scaled = std::ldexp(value, kGridBits);
  return std::abs(value) <= limit && scaled == std::nearbyint(scaled);  // false for NaN
}
}  // namespace

bool is_valid(const Plane& plane) {
  const Vec3 n = plane.normal;
  return on_grid(n.x, 1) && on_grid(n.y, 1) && on_grid(n.z, 1) && on_grid(plane.offset, 2) &&
         std::abs(glm::dot(n, n) - 1) < 1e-14;
}

}  // namespace spoctree
