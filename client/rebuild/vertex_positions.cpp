#include "client/rebuild/vertex_positions.hpp"

#include <glm/geometric.hpp>

#include "common/geometry/predicates.hpp"

namespace spoctree {

namespace {

/// Below this determinant of the normals, the planes fix the point no better than it is known.
constexpr double kLeastIndependence = 1e-3;

}  // namespace

std::vector<Vec3> best_positions(const Chain& chain, const Carriers& carriers,
                                 const VertexWelder& welder) {
  std::vector<Vec3> positions = welder.vertices();
  // The carriers around each vertex, as rows of a table; most occur twice.
  std::vector<std::uint32_t> begin(positions.size() + 1);
  for (const ChainEdge& use : chain) {
    ++begin[use.a + 1];
    ++begin[use.b + 1];
  }
  for (std::size_t v = 0; v < positions.size(); ++v) begin[v + 1] += begin[v];
  std::vector<std::uint32_t> around(begin.back());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (const ChainEdge& use : chain) {
    around[next[use.a]++] = use.carrier;
    around[next[use.b]++] = use.carrier;
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (begin[v] == begin[v + 1]) continue;
    // Greedy: the plane most across the first, then the one most across both.
    const std::uint32_t p = around[begin[v]];
    std::uint32_t q = p;
    std::uint32_t r = p;
    Vec3 pq{0.0};
    for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
      const Vec3 c = glm::cross(carriers.plane(p).normal, carriers.plane(around[i]).normal);
      if (glm::dot(c, c) > glm::dot(pq, pq)) {
        pq = c;
        q = around[i];
      }
    }
    double best = 0;
    for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
      const double determinant = std::abs(glm::dot(pq, carriers.plane(around[i]).normal));
      if (determinant > best) {
        best = determinant;
        r = around[i];
      }
    }
    if (best < kLeastIndependence) continue;
    const Vec3 point =
        intersection_point(carriers.plane(p), carriers.plane(q), carriers.plane(r)).position;
    if (glm::distance(point, positions[v]) < 4 * welder.tolerance()) positions[v] = point;
  }
  return positions;
}

}  // namespace spoctree
