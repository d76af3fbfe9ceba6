#include "server/solid/nearest_on_planes.hpp"

#include <glm/geometric.hpp>

namespace spoctree {

Vec3 way_onto_planes(std::span<const PlaneNear> planes) {
  Vec3 way{0.0};
  Vec3 across[3];  // an orthonormal basis of the normals so far
  for (int count = 0; count < 3; ++count) {
    double most = kSamePlane;
    const PlaneNear* next = nullptr;
    for (const PlaneNear& plane : planes) {
      Vec3 rest = plane.normal;
      for (int i = 0; i < count; ++i) rest -= glm::dot(rest, across[i]) * across[i];
      if (!(glm::length(rest) > most)) continue;
      most = glm::length(rest);
      next = &plane;
      across[count] = rest / most;
    }
    if (next == nullptr) break;
    way += across[count] * ((next->ahead - glm::dot(next->normal, way)) / most);
  }
  return way;
}

}  // namespace spoctree
