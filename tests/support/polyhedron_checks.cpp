#include "tests/support/polyhedron_checks.hpp"

#include <map>

namespace spoctree {

namespace {

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::vector<std::optional<RationalPoint>> vertex_points(const Polyhedron& polyhedron,
                                                        const PlaneSet& planes) {
  std::vector<std::optional<RationalPoint>> points;
  for (const PolyhedronVertex& vertex : polyhedron.vertices) {
    points.push_back(exact_intersection(planes[vertex.planes[0]], planes[vertex.planes[1]],
                                        planes[vertex.planes[2]]));
  }
  return points;
}

}  // namespace

std::string structure_error(const Polyhedron& polyhedron, const PlaneSet& planes) {
  const auto points = vertex_points(polyhedron, planes);
  std::set<RationalPoint> distinct;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i]) return "a vertex whose planes do not meet in one point";
    if (!distinct.insert(*points[i]).second) return "two vertices in one point";
    const PolyhedronVertex& vertex = polyhedron.vertices[i];
    if (exact_distance(to_rational(vertex.position), *points[i]) > Rational(vertex.error)) {
      return "a vertex farther from its position than its error";
    }
  }

  std::map<PlaneRef, std::map<std::pair<std::uint32_t, std::uint32_t>, PlaneRef>> edges_of;
  std::vector<int> uses(points.size(), 0);
  std::size_t edge_count = 0;
  for (const Polyhedron::Face& face : polyhedron.faces) {
    const Plane plane = planes[face.plane];
    const auto loop = polyhedron.loop(face);
    if (loop.size() < 3) return "a face of fewer than three corners";
    if (edges_of.contains(face.plane)) return "two faces on one plane";
    auto& edges = edges_of[face.plane];
    for (const auto& point : points) {
      if (exact_value(plane, *point) > 0) return "a vertex outside the plane of a face";
    }
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::uint32_t a = loop[k].vertex;
      const std::uint32_t b = loop[(k + 1) % loop.size()].vertex;
      const std::uint32_t c = loop[(k + 2) % loop.size()].vertex;
      if (a >= points.size()) return "a corner of no vertex";
      if (exact_value(plane, *points[a]) != 0) return "a corner off the plane of its face";
      const RationalPoint turn =
          cross(minus(*points[b], *points[a]), minus(*points[c], *points[b]));
      if (dot(turn, to_rational(plane.normal)) <= 0) return "a corner that does not turn left";
      if (loop[k].across >= polyhedron.faces.size()) return "an edge with no face across";
      if (!edges.emplace(std::pair{a, b}, polyhedron.plane_across(loop[k])).second)
        return "an edge twice in a face";
      ++uses[a];
      ++edge_count;
    }
  }
  for (const auto& [plane, edges] : edges_of) {
    for (const auto& [edge, across] : edges) {
      const auto other = edges_of.find(across);
      if (other == edges_of.end()) return "an edge with no face across";
      const auto twin = other->second.find({edge.second, edge.first});
      if (twin == other->second.end()) return "an edge that the face across does not have";
      if (twin->second != plane) return "an edge that the face across shares with another face";
    }
  }
  for (const int count : uses) {
    if (count < 3) return "a vertex of fewer than three faces";
  }
  if (edge_count % 2 != 0 || points.size() + polyhedron.faces.size() != edge_count / 2 + 2) {
    return "V - E + F is not 2";
  }
  return "";
}

std::set<RationalPoint> exact_vertices(const Polyhedron& polyhedron, const PlaneSet& planes) {
  std::set<RationalPoint> result;
  for (const auto& point : vertex_points(polyhedron, planes)) {
    if (point) result.insert(*point);
  }
  return result;
}

Rational exact_volume(const Polyhedron& polyhedron, const PlaneSet& planes) {
  const auto points = vertex_points(polyhedron, planes);
  Rational six_volumes = 0;
  for (const Polyhedron::Face& face : polyhedron.faces) {
    const auto loop = polyhedron.loop(face);
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      six_volumes +=
          dot(*points[loop[0].vertex], cross(*points[loop[k].vertex], *points[loop[k + 1].vertex]));
    }
  }
  return six_volumes / 6;
}

std::set<RationalPoint> enumerated_vertices(const std::vector<Plane>& half_spaces) {
  std::set<RationalPoint> vertices;
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const auto point = exact_intersection(half_spaces[i], half_spaces[j], half_spaces[k]);
        if (!point) continue;
        bool is_inside = true;
        for (std::size_t l = 0; l < half_spaces.size() && is_inside; ++l) {
          is_inside = exact_value(half_spaces[l], *point) <= 0;
        }
        if (is_inside) vertices.insert(*point);
      }
    }
  }
  return vertices;
}

bool has_interior(const std::set<RationalPoint>& vertices, const std::vector<Plane>& half_spaces) {
  if (vertices.empty()) return false;
  // The mean of the vertices is inside every plane that does not contain all of them.
  RationalPoint mean{0, 0, 0};
  for (const RationalPoint& vertex : vertices) {
    for (std::size_t i = 0; i < 3; ++i) mean[i] += vertex[i] / Rational(vertices.size());
  }
  for (const Plane& plane : half_spaces) {
    if (exact_value(plane, mean) >= 0) return false;
  }
  return true;
}

}  // namespace spoctree
