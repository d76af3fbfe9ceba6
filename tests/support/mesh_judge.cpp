#include "tests/support/mesh_judge.hpp"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "tests/support/cgal_mesh.hpp"

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Triangles = std::vector<Kernel::Triangle_3>;
using TriangleTree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;
using Side = CGAL::Side_of_triangle_mesh<Surface, Kernel>;

Point to_point(Vec3 p) { return {p.x, p.y, p.z}; }
Vec3 to_vec(const Point& p) { return {p.x(), p.y(), p.z()}; }

using Corners = std::array<std::uint32_t, 3>;

}  // namespace

struct MeshJudge::Data {
  std::vector<Vec3> points;
  std::vector<Corners> corners;
  std::vector<double> area_up_to;
  Triangles triangles;
  TriangleTree tree;
  Surface surface;
  bool is_manifold = true;
  std::unique_ptr<Side> side;
  Vec3 lower{0.0};
  Vec3 upper{0.0};

  MeshJudge::Sample on_triangle(std::size_t i, double u, double v) const {
    const Vec3 a = points[corners[i][0]];
    const Vec3 b = points[corners[i][1]];
    const Vec3 c = points[corners[i][2]];
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Vec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    return {a + u * (b - a) + v * (c - a), length > 0 ? normal / length : Vec3(0, 0, 1)};
  }
};

MeshJudge::MeshJudge(const PlainMesh& mesh) {
  auto data = std::make_unique<Data>();
  data->points = mesh.points;
  for (const auto& face : mesh.faces) {
    const auto triangles = triangulate_with_cgal(mesh.points, face);
    data->corners.insert(data->corners.end(), triangles.begin(), triangles.end());
  }
  double area = 0;
  data->lower = data->upper = mesh.points.at(0);
  std::vector<Surface::Vertex_index> vertices;
  for (const Vec3 p : mesh.points) {
    vertices.push_back(data->surface.add_vertex(to_point(p)));
    data->lower = glm::min(data->lower, p);
    data->upper = glm::max(data->upper, p);
  }
  for (const Corners& t : data->corners) {
    const Vec3 a = mesh.points[t[0]];
    const Vec3 b = mesh.points[t[1]];
    const Vec3 c = mesh.points[t[2]];
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
    data->area_up_to.push_back(area);
    const Kernel::Triangle_3 triangle(to_point(a), to_point(b), to_point(c));
    if (!triangle.is_degenerate()) data->triangles.push_back(triangle);
    data->is_manifold &= data->surface.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]) !=
                         Surface::null_face();
  }
  data->tree.insert(data->triangles.begin(), data->triangles.end());
  data->tree.accelerate_distance_queries();
  data->is_manifold = data->is_manifold && CGAL::is_closed(data->surface);
  if (data->is_manifold) data->side = std::make_unique<Side>(data->surface);
  data_ = std::move(data);
}

MeshJudge::~MeshJudge() = default;

bool MeshJudge::is_inside(Vec3 point) const {
  if (!data_->is_manifold) throw std::logic_error("the mesh is no closed manifold");
  return (*data_->side)(to_point(point)) == CGAL::ON_BOUNDED_SIDE;
}

double MeshJudge::distance(Vec3 point) const {
  return glm::length(to_vec(data_->tree.closest_point(to_point(point))) - point);
}

MeshJudge::Sample MeshJudge::sample(Random& random) const {
  const auto& areas = data_->area_up_to;
  const double wanted = random.between(0, areas.back());
  const auto found = std::lower_bound(areas.begin(), areas.end(), wanted);
  const auto index = std::min<std::ptrdiff_t>(found - areas.begin(), std::ssize(areas) - 1);
  const double u = random.unit();
  const double v = random.unit();
  return data_->on_triangle(static_cast<std::size_t>(index), u, v);
}

MeshJudge::Sample MeshJudge::sample_triangle(Random& random) const {
  const auto index = random.below(static_cast<std::uint32_t>(data_->corners.size()));
  const double u = random.unit();
  const double v = random.unit();
  return data_->on_triangle(index, u, random.chance(1.0 / 3) ? 0 : v);
}

Vec3 MeshJudge::lower() const { return data_->lower; }
Vec3 MeshJudge::upper() const { return data_->upper; }
double MeshJudge::diagonal() const { return glm::length(data_->upper - data_->lower); }

double MeshJudge::farthest(const MeshJudge& from, std::size_t samples, Random& random) const {
  double most = 0;
  const auto look_at = [&](Vec3 point) { most = std::max(most, distance(point)); };
  const Data& other = *from.data_;
  for (const Corners& corners : other.corners) {
    for (const std::uint32_t corner : corners) look_at(other.points[corner]);
  }
  for (std::size_t i = 0; i < other.corners.size(); ++i) {
    look_at(other.on_triangle(i, 1.0 / 3, 1.0 / 3).point);
    look_at(other.on_triangle(i, 0.5, 0).point);
  }
  for (std::size_t i = 0; i < samples; ++i) look_at(from.sample(random).point);
  return most;
}

}  // namespace spoctree
