#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include "tools/benchmark/query_benchmark.hpp"

namespace spoctree {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

Point to_point(Vec3 p) { return {p.x, p.y, p.z}; }
}  // namespace

struct CgalQueries::Data {
  explicit Data(const Solid& solid) {
    std::vector<Mesh::Vertex_index> vertices;
    for (const Vec3 vertex : solid.vertices) vertices.push_back(mesh.add_vertex(to_point(vertex)));
    for (const SolidTriangle& t : solid.triangles) {
      mesh.add_face(vertices[t.vertex[0]], vertices[t.vertex[1]], vertices[t.vertex[2]]);
    }
    tree.insert(faces(mesh).begin(), faces(mesh).end(), mesh);
    tree.build();
    side = std::make_unique<const CGAL::Side_of_triangle_mesh<Mesh, Kernel>>(tree);
  }
  Mesh mesh;
  Tree tree;
  std::unique_ptr<const CGAL::Side_of_triangle_mesh<Mesh, Kernel>> side;
};

CgalQueries::CgalQueries(const Solid& solid) : data_(std::make_unique<const Data>(solid)) {}
CgalQueries::~CgalQueries() = default;

PointClass CgalQueries::classify(Vec3 point) const {
  switch ((*data_->side)(to_point(point))) {
    case CGAL::ON_BOUNDED_SIDE:
      return PointClass::In;
    case CGAL::ON_BOUNDARY:
      return PointClass::On;
    default:
      return PointClass::Out;
  }
}

bool CgalQueries::hits(const Ray& ray) const {
  const Kernel::Ray_3 asked(to_point(ray.origin), to_point(ray.origin + ray.direction));
  return data_->tree.first_intersection(asked).has_value();
}

}  // namespace spoctree
