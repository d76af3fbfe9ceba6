#include "tests/support/surface_judge.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

namespace spoctree {

namespace {

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

/// Vertices were moved by no more than this (universe units).
constexpr double kNear = 1e-9;

std::string name(const char* what, std::size_t index) {
  return std::string(what) + ' ' + std::to_string(index) + ": ";
}

Vec3 area_vector(const Surface& surface, const Surface::Loop& loop) {
  Vec3 sum{0.0};
  const auto vertices = surface.vertices_of(loop);
  const Vec3 origin = surface.vertices[vertices[0]];
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    sum += glm::cross(surface.vertices[vertices[k]] - origin,
                      surface.vertices[vertices[(k + 1) % vertices.size()]] - origin);
  }
  return 0.5 * sum;
}

}  // namespace

std::vector<std::string> faults_of(const Surface& surface, const Octree& tree) {
  std::vector<std::string> faults;
  const auto fail = [&](std::string text) { faults.push_back(std::move(text)); };
  std::map<DirectedEdge, std::vector<std::uint32_t>> faces_of_edge;
  std::size_t loops_seen = 0;
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    const Surface::Face& face = surface.faces[f];
    const Plane plane = tree.plane_set()[face.plane];
    if (face.loop_count == 0) fail(name("face", f) + "no loop");
    bool is_outer = true;
    double area = 0;
    for (const Surface::Loop& loop : surface.loops_of(face)) {
      ++loops_seen;
      const auto vertices = surface.vertices_of(loop);
      if (vertices.size() < 3) fail(name("face", f) + "a loop of fewer than 3 vertices");
      if (std::set<std::uint32_t>(vertices.begin(), vertices.end()).size() != vertices.size()) {
        fail(name("face", f) + "a loop with a vertex twice");
      }
      for (std::size_t k = 0; k < vertices.size(); ++k) {
        if (vertices[k] >= surface.vertices.size()) {
          fail(name("face", f) + "a vertex out of range");
          return faults;
        }
        const double off = glm::dot(plane.normal, surface.vertices[vertices[k]]) - plane.offset;
        if (!(std::abs(off) < kNear)) {
          fail(name("face", f) + "a vertex off the plane by " + std::to_string(off));
        }
        faces_of_edge[{vertices[k], vertices[(k + 1) % vertices.size()]}].push_back(f);
      }
      const double loop_area = glm::dot(area_vector(surface, loop), plane.normal);
      if ((loop_area > 0) != is_outer) {
        fail(name("face", f) + (is_outer ? "an outer loop" : "a hole") + " of area " +
             std::to_string(loop_area * 1e12) + "e-12");
      }
      area += loop_area;
      is_outer = false;
    }
    if (!(area > 0)) fail(name("face", f) + "no area");
  }
  if (loops_seen != surface.loops.size()) fail("loops without a face");

  std::size_t undirected = 0;
  for (const auto& [edge, faces] : faces_of_edge) {
    const auto opposite = faces_of_edge.find({edge.second, edge.first});
    const std::size_t back = opposite == faces_of_edge.end() ? 0 : opposite->second.size();
    if (faces.size() != back) fail(name("vertex", edge.first) + "an open edge");
    if (edge.first < edge.second || back == 0) ++undirected;
    if (back == 0) continue;
    for (const std::uint32_t f : faces) {
      for (const std::uint32_t g : opposite->second) {
        if (surface.faces[f].plane == surface.faces[g].plane) {
          fail(name("face", f) + "an edge within a flat face");
        }
      }
    }
  }
  if (undirected != surface.edges.size()) fail("edges missing or twice");
  std::vector<std::uint32_t> degree(surface.vertices.size(), 0);
  for (std::size_t e = 0; e < surface.edges.size(); ++e) {
    const Surface::Edge& edge = surface.edges[e];
    if (edge.a >= edge.b) fail(name("edge", e) + "ends in the wrong order");
    std::vector<std::uint32_t> forward;
    std::vector<std::uint32_t> backward;
    for (const Surface::Side& side : surface.sides_of(edge)) {
      (side.forward ? forward : backward).push_back(side.face);
    }
    if (forward != faces_of_edge[{edge.a, edge.b}] || backward != faces_of_edge[{edge.b, edge.a}]) {
      fail(name("edge", e) + "sides that are not those of the loops");
    }
    ++degree[edge.a];
    ++degree[edge.b];
  }
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (degree[v] < 3) fail(name("vertex", v) + std::to_string(degree[v]) + " edges");
  }
  return faults;
}

std::vector<std::string> faults_of(const PolygonMesh& mesh) {
  std::vector<std::string> faults;
  std::map<DirectedEdge, int> balance;
  for (std::size_t i = 0; i < mesh.polygon_count(); ++i) {
    const std::vector<std::uint32_t> corners(mesh.corners.begin() + mesh.polygon_begin[i],
                                             mesh.corners.begin() + mesh.polygon_begin[i + 1]);
    if (corners.size() < 3) faults.push_back(name("polygon", i) + "fewer than 3 corners");
    if (std::set<std::uint32_t>(corners.begin(), corners.end()).size() != corners.size()) {
      faults.push_back(name("polygon", i) + "a corner twice");
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t a = corners[k];
      const std::uint32_t b = corners[(k + 1) % corners.size()];
      if (a >= mesh.vertices.size()) faults.push_back(name("polygon", i) + "a corner out of range");
      ++balance[{a, b}];
      --balance[{b, a}];
    }
  }
  for (const auto& [edge, count] : balance) {
    if (count != 0) faults.push_back(name("vertex", edge.first) + "an open edge");
  }
  return faults;
}

double volume_of(const PolygonMesh& mesh) {
  double six_volumes = 0;
  for (std::size_t i = 0; i < mesh.polygon_count(); ++i) {
    for (std::uint32_t k = mesh.polygon_begin[i] + 1; k + 1 < mesh.polygon_begin[i + 1]; ++k) {
      const Vec3 a = mesh.vertices[mesh.corners[mesh.polygon_begin[i]]] - mesh.vertices[0];
      const Vec3 b = mesh.vertices[mesh.corners[k]] - mesh.vertices[0];
      const Vec3 c = mesh.vertices[mesh.corners[k + 1]] - mesh.vertices[0];
      six_volumes += glm::dot(a, glm::cross(b, c));
    }
  }
  return six_volumes / 6;
}

int winding_number(const Surface& surface, Vec3 point) {
  // The signed crossings of the ray towards +x with fans of triangles: what a fan covers besides
  // its face, it covers as often one way as the other.
  int number = 0;
  const auto turn = [&](Vec3 a, Vec3 b) {
    return (a.y - point.y) * (b.z - point.z) - (a.z - point.z) * (b.y - point.y);
  };
  for (const Surface::Loop& loop : surface.loops) {
    const auto vertices = surface.vertices_of(loop);
    const Vec3 a = surface.vertices[vertices[0]];
    for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
      const Vec3 b = surface.vertices[vertices[k]];
      const Vec3 c = surface.vertices[vertices[k + 1]];
      const double ab = turn(a, b);
      const double bc = turn(b, c);
      const double ca = turn(c, a);
      const bool is_front = ab > 0 && bc > 0 && ca > 0;
      const bool is_back = ab < 0 && bc < 0 && ca < 0;
      if (!is_front && !is_back) continue;
      const double x = (a.x * bc + b.x * ca + c.x * ab) / (ab + bc + ca);
      if (x > point.x) number += is_front ? 1 : -1;
    }
  }
  return number;
}

}  // namespace spoctree
