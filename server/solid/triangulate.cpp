#include "server/solid/triangulate.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "server/solid/first_found.hpp"
#include "server/solid/grid_integers.hpp"
#include "server/solid/split_polygon.hpp"

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

using Face = std::span<const std::uint32_t>;

// Corners that were in one plane are within this of it on the grid, in universe units.
constexpr double kRounding = 0x1p-48;

bool is_on_one_line(Face face, std::span<const glm::dvec3> points) {
  const auto point = [&](std::size_t i) {
    const glm::dvec3 p = points[face[i]];
    return Kernel::Point_3(p.x, p.y, p.z);
  };
  // Any corner that differs from the first spans the line.
  std::size_t other = 1;
  while (other < face.size() && points[face[other]] == points[face[0]]) ++other;
  for (std::size_t i = other + 1; i < face.size(); ++i) {
    if (!CGAL::collinear(point(0), point(other), point(i))) return false;
  }
  return true;
}

// Newell's normal: twice the area vector, whichever the shape. Summed around the first corner, so
// that small faces far from the centre keep their digits.
Vec3 newell_normal(Face face, const std::vector<Vec3>& vertices) {
  Vec3 sum{0.0};
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    sum += glm::cross(vertices[face[i]] - vertices[face[0]],
                      vertices[face[i + 1]] - vertices[face[0]]);
  }
  return sum;
}

double unevenness(Face face, const std::vector<Vec3>& vertices, Vec3 normal) {
  const double length = glm::length(normal);
  if (length == 0) return 0;
  Vec3 middle{0.0};
  for (const std::uint32_t v : face) middle += vertices[v] / static_cast<double>(face.size());
  double largest = 0;
  for (const std::uint32_t v : face) {
    largest = std::max(largest, std::abs(glm::dot(normal, vertices[v] - middle)) / length);
  }
  return largest;
}

// The face's corners seen along an axis, so that it runs counter-clockwise: dropping a coordinate
// rounds nothing.
std::vector<glm::dvec2> view(Face face, const std::vector<Vec3>& vertices, int axis,
                             bool from_below) {
  const int u = (axis + (from_below ? 2 : 1)) % 3;
  const int v = (axis + (from_below ? 1 : 2)) % 3;
  std::vector<glm::dvec2> points;
  points.reserve(face.size());
  for (const std::uint32_t i : face) points.emplace_back(vertices[i][u], vertices[i][v]);
  return points;
}

// A corner that is all but in line with its neighbours must not be cut off: what way a triangle
// faces that is so many times thinner than the others would be is chance.
constexpr double kThinnest = 0.01;

// The height of a triangle, as a fraction of its longest edge.
double thickness(Vec3 a, Vec3 b, Vec3 c) {
  const double longest =
      std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
  return glm::length(glm::cross(b - a, c - a)) / longest;
}

// Of the diagonals that lie inside, the shorter one. A quadrilateral that splits into two triangles
// of its own orientation is simple.
bool split_quadrilateral(const std::vector<glm::dvec2>& p, Face face, const GridMesh& mesh,
                         std::vector<Corners>& triangles) {
  const auto point = [&](int i) { return Kernel::Point_2(p[i].x, p[i].y); };
  const auto is_left_turn = [&](int i, int j, int k) {
    return CGAL::orientation(point(i), point(j), point(k)) == CGAL::LEFT_TURN;
  };
  const bool can_02 = is_left_turn(0, 1, 2) && is_left_turn(0, 2, 3);
  const bool can_13 = is_left_turn(0, 1, 3) && is_left_turn(1, 2, 3);
  if (!can_02 && !can_13) return false;
  const auto length = [&](int i, int j) {
    return glm::distance(mesh.vertices[face[i]], mesh.vertices[face[j]]);
  };
  const auto thinner = [&](int i, int j, int k, int l, int m, int n) {
    const auto at = [&](int corner) { return mesh.vertices[face[corner]]; };
    return std::min(thickness(at(i), at(j), at(k)), thickness(at(l), at(m), at(n)));
  };
  bool is_02_better = length(0, 2) <= length(1, 3);
  if (can_02 && can_13) {
    const double by_02 = thinner(0, 1, 2, 0, 2, 3);
    const double by_13 = thinner(0, 1, 3, 1, 2, 3);
    if (by_02 < kThinnest * by_13) is_02_better = false;
    if (by_13 < kThinnest * by_02) is_02_better = true;
  }
  if (can_02 && (!can_13 || is_02_better)) {
    triangles.push_back({face[0], face[1], face[2]});
    triangles.push_back({face[0], face[2], face[3]});
  } else {
    triangles.push_back({face[0], face[1], face[3]});
    triangles.push_back({face[1], face[2], face[3]});
  }
  return true;
}

bool split_face(Face face, const GridMesh& mesh, Vec3 normal, std::vector<Corners>& triangles) {
  int axes[3] = {0, 1, 2};
  std::stable_sort(axes, axes + 3,
                   [&](int i, int j) { return std::abs(normal[i]) > std::abs(normal[j]); });
  for (const int axis : axes) {
    if (normal[axis] == 0) continue;
    const std::vector<glm::dvec2> points = view(face, mesh.vertices, axis, normal[axis] < 0);
    if (face.size() == 4 ? split_quadrilateral(points, face, mesh, triangles)
                         : split_polygon(points, face, triangles)) {
      return true;
    }
  }
  return false;
}

using Fault = FirstFound<std::size_t>;  // faces, or triangles, by number

}  // namespace

void triangulate(const PolygonSoup& soup, GridMesh& mesh, SolidReport& report) {
  if (soup.face_count() == 0) mesh.fail("empty: no faces");
  Fault degenerate;
  Fault crossing;
  mesh.triangles.reserve(soup.face_count());
  for (std::size_t i = 0; i < soup.face_count(); ++i) {
    const Face face = soup.face(i);
    if (is_on_one_line(face, mesh.points)) {
      degenerate.add(i);
    } else if (face.size() == 3) {
      mesh.triangles.push_back({face[0], face[1], face[2]});
    } else {
      const Vec3 normal = newell_normal(face, mesh.vertices);
      ++report.triangulated_faces;
      const double uneven = unevenness(face, mesh.vertices, normal);
      if (uneven > kRounding) ++report.uneven_faces;
      report.largest_unevenness = std::max(report.largest_unevenness, uneven / mesh.box_diagonal);
      if (!split_face(face, mesh, normal, mesh.triangles)) crossing.add(i);
    }
    if (mesh.triangles.size() > kMaxTriangles) {
      mesh.fail("more than " + std::to_string(kMaxTriangles) + " triangles");
    }
  }
  report.input_faces = soup.face_count();
  const auto place_of_face = [&](std::size_t i) { return mesh.place(soup.face(i)); };
  if (degenerate.count() > 0) {
    mesh.fail_as_unsound("degenerate: " + counted(degenerate.count(), "face") + " without area, " +
              degenerate.places(place_of_face));
  }
  if (crossing.count() > 0) {
    mesh.fail(counted(crossing.count(), "polygon") + " with edges that cross or touch, " +
              crossing.places(place_of_face));
  }
  Fault vanishing;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners& t = mesh.triangles[i];
    const AreaVector area =
        area_vector(to_grid_integers(mesh.vertices[t[0]]), to_grid_integers(mesh.vertices[t[1]]),
                    to_grid_integers(mesh.vertices[t[2]]));
    if (area == AreaVector{0, 0, 0}) vanishing.add(i);
  }
  if (vanishing.count() > 0) {
    mesh.fail_as_unsound("degenerate: " + counted(vanishing.count(), "triangle") +
              " thinner than 2^-52 of the extent, " +
              vanishing.places([&](std::size_t i) { return mesh.place(mesh.triangles[i]); }));
  }
}

}  // namespace spoctree
