#include "common/tree/model_queries.hpp"

#include <algorithm>
#include <cmath>

namespace spoctree {

PointClass classify_in_model(const QueryIndex& index, Vec3 point) {
  return index.classify(index.tree().universe.to_grid(point));
}

namespace {

/// Moves the origin of a ray that comes from far off to where, along the axis that it goes along
/// most, it is two diagonals off the universe. Returns by how many directions.
long double come_near(const Universe& universe, Vec3& origin, Vec3 direction) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(direction[i]) > std::abs(direction[axis])) axis = i;
  }
  const double near =
      universe.center[axis] - std::copysign(2 * universe.diagonal(), direction[axis]);
  // Long doubles, for quotients and products beyond what doubles can hold.
  const long double skipped = (static_cast<long double>(near) - origin[axis]) / direction[axis];
  if (!(skipped > 0)) return 0;
  for (int i = 0; i < 3; ++i) {
    origin[i] = i == axis ? near : static_cast<double>(origin[i] + skipped * direction[i]);
  }
  return skipped;
}

}  // namespace

RayAnswer first_hit_in_model(const QueryIndex& index, Vec3 origin, Vec3 direction) {
  const Universe& universe = index.tree().universe;
  // Powers of two only, and none of them before the direction has a sensible length: exact.
  int exponent = 0;
  std::frexp(std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}),
             &exponent);
  const long double skipped = come_near(universe, origin, direction);
  Ray ray{universe.to_grid(origin)};
  for (int axis = 0; axis < 3; ++axis) ray.direction[axis] = std::ldexp(direction[axis], -exponent);
  RayAnswer answer = index.first_hit(ray);
  answer.first = std::ldexp(answer.first, universe.scale_exponent - exponent);
  answer.last = std::ldexp(answer.last, universe.scale_exponent - exponent);
  answer.first = static_cast<double>(answer.first + skipped);
  answer.last = static_cast<double>(answer.last + skipped);
  return answer;
}

}  // namespace spoctree
