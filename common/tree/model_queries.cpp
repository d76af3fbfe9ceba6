#include "common/tree/model_queries.hpp"

#include <algorithm>
#include <cmath>

namespace spoctree {

PointClass classify_in_model(const QueryIndex& index, Vec3 point) {
  return index.classify(index.tree().universe.to_grid(point));
}

RayAnswer first_hit_in_model(const QueryIndex& index, Vec3 origin, Vec3 direction) {
  const Universe& universe = index.tree().universe;
  // Powers of two only, and none of them before the direction has a sensible length: exact.
  int exponent = 0;
  std::frexp(std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}),
             &exponent);
  Ray ray{universe.to_grid(origin)};
  for (int axis = 0; axis < 3; ++axis) ray.direction[axis] = std::ldexp(direction[axis], -exponent);
  RayAnswer answer = index.first_hit(ray);
  answer.first = std::ldexp(answer.first, universe.scale_exponent - exponent);
  answer.last = std::ldexp(answer.last, universe.scale_exponent - exponent);
  return answer;
}

}  // namespace spoctree
