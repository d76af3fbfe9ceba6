#include "server/build/convex_distance.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace spoctree {

namespace {

/// What doubles make of the side of an edge is off by less than this times the lengths of the edge
/// and of the way to the point.
constexpr double kSideRounding = 0x1p-49;

/// Doubles tell a point's side of a plane to better than this.
constexpr double kPlaneRounding = 1e-14;

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 way = b - a;
  const double squared = glm::dot(way, way);
  const double t = squared > 0 ? glm::clamp(glm::dot(p - a, way) / squared, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * way);
}

/// The distance of a point from a convex polyhedron, up to the errors of its vertices: the nearest
/// point is in a face that the point is beyond, below the point or on an edge. A point is taken to
/// be over a face only if it is for certain: faces may be so narrow, or so small, that their
/// corners are the same doubles, and then every point of the plane would seem to be over them.
/// Any number up to `small` will do for a distance up to that.
double distance_to(const Polyhedron& piece, const PlaneSet& planes, Vec3 p, double small) {
  double least = std::numeric_limits<double>::infinity();
  bool is_inside = true;
  for (const Polyhedron::Face& face : piece.faces) {
    const Plane plane = planes[face.plane];
    const double height = glm::dot(plane.normal, p) - plane.offset;
    if (height < -kPlaneRounding) continue;
    is_inside = false;
    if (height >= least) continue;
    const auto loop = piece.loop(face);
    bool is_over_face = true;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 a = piece.vertices[loop[i].vertex].position;
      const Vec3 b = piece.vertices[loop[i + 1 == loop.size() ? 0 : i + 1].vertex].position;
      least = std::min(least, distance_to_segment(p, a, b));
      const Vec3 edge = b - a;
      const Vec3 way = p - a;
      const double side = glm::dot(glm::cross(plane.normal, edge), way);
      const double rounding = kSideRounding * kSideRounding * glm::dot(edge, edge);
      if (side <= 0 || side * side <= rounding * glm::dot(way, way)) is_over_face = false;
    }
    if (is_over_face) {
      least = std::min(least, std::abs(height));
    }
    if (least <= small) return least;
  }
  return is_inside ? 0 : least;
}

}  // namespace

double largest_distance(const Polyhedron& part, const Polyhedron& piece, const PlaneSet& planes,
                        double enough) {
  double piece_error = 0;
  for (const PolyhedronVertex& vertex : piece.vertices) {
    piece_error = std::max(piece_error, vertex.error);
  }
  double largest = 0;
  for (const PolyhedronVertex& vertex : part.vertices) {
    const double error = 2 * (vertex.error + piece_error);
    largest =
        std::max(largest, distance_to(piece, planes, vertex.position, largest - error) + error);
    if (largest >= enough) break;
  }
  return largest;
}

}  // namespace spoctree
