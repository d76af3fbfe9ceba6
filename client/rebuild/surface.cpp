#include "client/rebuild/surface.hpp"

#include <glm/geometric.hpp>

#include "client/rebuild/surface_rebuilder.hpp"

namespace spoctree {

Surface rebuild_surface(const Octree& tree, std::uint32_t level) {
  return SurfaceRebuilder().rebuild(tree, level);
}

namespace {

/// Calls visit(a, b, c) for triangles whose signed areas add up to each face's.
template <class Visit>
void visit_fans(const Surface& surface, Visit&& visit) {
  for (const Surface::Loop& loop : surface.loops) {
    const auto vertices = surface.vertices_of(loop);
    for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
      visit(surface.vertices[vertices[0]], surface.vertices[vertices[k]],
            surface.vertices[vertices[k + 1]]);
    }
  }
}

}  // namespace

double volume(const Surface& surface) {
  double six_volumes = 0;
  visit_fans(surface,
             [&](Vec3 a, Vec3 b, Vec3 c) { six_volumes += glm::dot(a, glm::cross(b, c)); });
  return six_volumes / 6;
}

double area(const Surface& surface) {
  double sum = 0;
  for (const Surface::Face& face : surface.faces) {
    Vec3 twice_area{0.0};
    for (const Surface::Loop& loop : surface.loops_of(face)) {
      const auto vertices = surface.vertices_of(loop);
      const Vec3 origin = surface.vertices[vertices[0]];
      for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
        twice_area += glm::cross(surface.vertices[vertices[k]] - origin,
                                 surface.vertices[vertices[k + 1]] - origin);
      }
    }
    sum += 0.5 * glm::length(twice_area);
  }
  return sum;
}

}  // namespace spoctree
