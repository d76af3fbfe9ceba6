// The corners of a polyhedron and a plane -> on which side they are, and where the plane crosses
// the edges between them.
#pragma once

#include <glm/geometric.hpp>

#include "common/geometry/polyhedron.hpp"
#include "common/geometry/predicates.hpp"

namespace spoctree {

/// Bound of the rounding in normal . position - offset, for corners of polyhedra in the universe
/// cube: three products of magnitude below 1 that sum up to sqrt(3) at most, and an offset below 2,
/// err by less than 9 * 2^-53.
inline constexpr double kVertexValueError = 0x1p-49;

/// The distance of the vertex from the plane, approximately.
inline double value_at(const PolyhedronVertex& vertex, const Plane& plane) {
  return glm::dot(plane.normal, vertex.position) - plane.offset;
}

/// Exact side of the vertex; `value` is value_at(vertex, plane), `carrier` the plane's.
inline int side_of_vertex(const PolyhedronVertex& vertex, double value, PlaneRef carrier,
                          const Plane& plane, const PlaneSet& planes) {
  // The vertex's own error is seen along a unit normal.
  if (std::abs(value) > 0x1p-47 + 2 * vertex.error) return value > 0 ? 1 : -1;
  for (const PlaneRef own : vertex.planes) {
    if (own.carrier() == carrier) return 0;
  }
  return side_of_intersection(planes[vertex.planes[0]], planes[vertex.planes[1]],
                              planes[vertex.planes[2]], plane);
}

/// An end of an edge, and value_at it.
struct EdgeEnd {
  const PolyhedronVertex* vertex;
  double value;
};

/// The point in which the edge between the faces `face` and `across` meets `plane`, which separates
/// its ends: interpolated where that is good to 2^-45, and computed from the planes elsewhere.
PolyhedronVertex edge_crossing(EdgeEnd from, EdgeEnd to, PlaneRef face, PlaneRef across,
                               PlaneRef plane, const PlaneSet& planes);

}  // namespace spoctree
