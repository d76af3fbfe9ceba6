#include "tests/unit/model/mesh_measures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace spoctree::model {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::uint32_t after(const Loop& face, std::size_t i) { return face[(i + 1) % face.size()]; }

OrientedPlane plane_of(const PolygonMesh& mesh, const Loop& face) {
  const glm::dvec3 normal = glm::normalize(vector_area(mesh, face));
  double offset = 0;
  for (const std::uint32_t corner : face) offset += glm::dot(normal, mesh.points[corner]);
  return {normal, offset / static_cast<double>(face.size())};
}

std::map<Edge, std::size_t> faces_of_edges(const PolygonMesh& mesh) {
  std::map<Edge, std::size_t> face_of;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t i = 0; i < mesh.faces[f].size(); ++i)
      face_of[{mesh.faces[f][i], after(mesh.faces[f], i)}] = f;
  return face_of;
}

bool segments_touch(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  const auto side = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
    const double turn = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    return (turn > 0) - (turn < 0);
  };
  const auto between = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
    return glm::dot(p - r, q - r) <= 0;
  };
  const int c_side = side(a, b, c), d_side = side(a, b, d);
  const int a_side = side(c, d, a), b_side = side(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && between(a, b, c)) || (d_side == 0 && between(a, b, d)) ||
         (a_side == 0 && between(c, d, a)) || (b_side == 0 && between(c, d, b));
}

}  // namespace

glm::dvec3 vector_area(const PolygonMesh& mesh, const Loop& face) {
  glm::dvec3 sum{0.0};
  const glm::dvec3& origin = mesh.points[face[0]];
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
    sum += glm::cross(mesh.points[face[i]] - origin, mesh.points[face[i + 1]] - origin);
  return 0.5 * sum;
}

double diagonal(const PolygonMesh& mesh) {
  glm::dvec3 low = mesh.points.at(0), high = low;
  for (const glm::dvec3& point : mesh.points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return glm::distance(low, high);
}

double volume(const PolygonMesh& mesh) {
  double sum = 0;
  for (const Loop& face : mesh.faces)
    sum += glm::dot(mesh.points[face[0]], vector_area(mesh, face)) / 3;
  return sum;
}

std::string why_not_closed(const PolygonMesh& mesh) {
  std::vector<Edge> edges;
  std::vector<bool> used(mesh.points.size(), false);
  for (const Loop& face : mesh.faces) {
    if (face.size() < 3) return "a face of fewer than three corners";
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (face[i] >= mesh.points.size()) return "a corner out of range";
      used[face[i]] = true;
      edges.emplace_back(face[i], after(face, i));
    }
  }
  if (std::find(used.begin(), used.end(), false) != used.end()) return "an unused point";

  std::set<std::tuple<double, double, double>> places;
  for (const glm::dvec3& point : mesh.points)
    if (!places.emplace(point.x, point.y, point.z).second) return "a point that stands twice";

  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    return "a directed edge that stands twice";
  for (const Edge& edge : edges)
    if (!std::binary_search(edges.begin(), edges.end(), Edge{edge.second, edge.first}))
      return "a directed edge without its reverse";
  return "";
}

double worst_flatness(const PolygonMesh& mesh) {
  double worst = 0;
  for (const Loop& face : mesh.faces) {
    const OrientedPlane plane = plane_of(mesh, face);
    for (const std::uint32_t corner : face)
      worst = std::max(worst, std::abs(glm::dot(plane.normal, mesh.points[corner]) - plane.offset));
  }
  return worst;
}

bool is_simple(const PolygonMesh& mesh, const Loop& face) {
  const glm::dvec3 normal = glm::abs(vector_area(mesh, face));
  const int axis = normal.x >= normal.y && normal.x >= normal.z ? 0 : normal.y >= normal.z ? 1 : 2;
  std::vector<glm::dvec2> corners;
  for (const std::uint32_t corner : face)
    corners.emplace_back(mesh.points[corner][(axis + 1) % 3], mesh.points[corner][(axis + 2) % 3]);

  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 a = corners[i], b = corners[(i + 1) % count], c = corners[(i + 2) % count];
    // The next side may not lead back over this one.
    if (a == b ||
        (glm::dot(b - a, c - b) < 0 && (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x)))
      return false;
    for (std::size_t j = i + 2; j < count; ++j)
      if ((j + 1) % count != i && segments_touch(a, b, corners[j], corners[(j + 1) % count]))
        return false;
  }
  return true;
}

std::vector<OrientedPlane> distinct_planes(const PolygonMesh& mesh) {
  const double size = diagonal(mesh);
  std::vector<OrientedPlane> planes;
  for (const Loop& face : mesh.faces) {
    const OrientedPlane plane = plane_of(mesh, face);
    const bool known = std::any_of(planes.begin(), planes.end(), [&](const OrientedPlane& other) {
      return glm::distance(plane.normal, other.normal) < 1e-9 &&
             std::abs(plane.offset - other.offset) < 1e-9 * size;
    });
    if (!known) planes.push_back(plane);
  }
  return planes;
}

std::size_t count_hull_planes(const PolygonMesh& mesh) {
  const double size = diagonal(mesh);
  const std::vector<OrientedPlane> planes = distinct_planes(mesh);
  return static_cast<std::size_t>(
      std::count_if(planes.begin(), planes.end(), [&](const OrientedPlane& plane) {
        return std::all_of(mesh.points.begin(), mesh.points.end(), [&](const glm::dvec3& point) {
          return glm::dot(plane.normal, point) <= plane.offset + 1e-9 * size;
        });
      }));
}

std::size_t count_shells(const PolygonMesh& mesh) {
  // Union-find over the points; edges join.
  std::vector<std::uint32_t> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t point) {
    while (parent[point] != point) point = parent[point] = parent[parent[point]];
    return point;
  };
  for (const Loop& face : mesh.faces)
    for (std::size_t i = 0; i < face.size(); ++i) parent[root(face[i])] = root(after(face, i));
  std::size_t shells = 0;
  for (std::uint32_t point = 0; point < parent.size(); ++point) shells += parent[point] == point;
  return shells;
}

long euler_characteristic(const PolygonMesh& mesh) {
  std::size_t corners = 0;
  for (const Loop& face : mesh.faces) corners += face.size();
  return static_cast<long>(mesh.points.size() + mesh.faces.size()) - static_cast<long>(corners / 2);
}

std::vector<Bend> bends_around(const PolygonMesh& mesh, std::uint32_t point) {
  const std::map<Edge, std::size_t> face_of = faces_of_edges(mesh);
  const auto first = face_of.lower_bound({point, 0});
  const std::size_t start = first->second;
  std::vector<Bend> bends;
  std::size_t face = start;
  do {
    const Loop& loop = mesh.faces[face];
    const auto at =
        static_cast<std::size_t>(std::find(loop.begin(), loop.end(), point) - loop.begin());
    const std::uint32_t next = after(loop, at);
    const std::size_t other = face_of.at({next, point});
    // Where the material is convex, the normals turn about the edge as a right-handed screw.
    const double turn =
        glm::dot(glm::cross(plane_of(mesh, loop).normal, plane_of(mesh, mesh.faces[other]).normal),
                 glm::normalize(mesh.points[next] - mesh.points[point]));
    bends.push_back(turn > 1e-9 ? Bend::Convex : turn < -1e-9 ? Bend::Concave : Bend::Flat);
    face = other;
  } while (face != start);
  return bends;
}

}  // namespace spoctree::model
