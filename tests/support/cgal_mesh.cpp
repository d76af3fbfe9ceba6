#include "tests/support/cgal_mesh.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

}  // namespace

PlainMesh read_with_cgal(const std::string& path) {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  if (!CGAL::IO::read_polygon_soup(path, points, faces)) {
    throw BadInput(path + ": CGAL cannot read");
  }
  CGAL::Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(points, faces);
  PlainMesh mesh;
  for (const Point& p : points) mesh.points.emplace_back(p.x(), p.y(), p.z());
  for (const auto& face : faces) mesh.faces.emplace_back(face.begin(), face.end());
  return mesh;
}

std::vector<std::array<std::uint32_t, 3>> triangulate_with_cgal(
    const std::vector<Vec3>& points, const std::vector<std::uint32_t>& polygon) {
  if (polygon.size() == 3) return {{polygon[0], polygon[1], polygon[2]}};
  // Each polygon on its own, so that surfaces that are no manifolds do as well.
  Surface surface;
  std::vector<Surface::Vertex_index> corners;
  for (const std::uint32_t corner : polygon) {
    const Vec3 p = points[corner];
    corners.push_back(surface.add_vertex({p.x, p.y, p.z}));
  }
  if (surface.add_face(corners) == Surface::null_face() ||
      !CGAL::Polygon_mesh_processing::triangulate_faces(surface)) {
    throw std::runtime_error("a polygon cannot be triangulated");
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto triangle : surface.faces()) {
    std::array<std::uint32_t, 3> found{};
    std::size_t k = 0;
    for (const auto vertex : vertices_around_face(surface.halfedge(triangle), surface)) {
      found.at(k++) = polygon[static_cast<std::size_t>(vertex)];
    }
    triangles.push_back(found);
  }
  return triangles;
}

}  // namespace spoctree
