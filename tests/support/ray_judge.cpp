#include "tests/support/ray_judge.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <glm/geometric.hpp>

namespace spoctree {

namespace {
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Kernel::Point_3 to_point(Vec3 p) { return {p.x, p.y, p.z}; }
}  // namespace

struct RayJudge::Data {
  Triangles triangles;
  Tree tree;
};

RayJudge::RayJudge(const PlainMesh& mesh) {
  auto data = std::make_unique<Data>();
  for (const auto& face : mesh.faces) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const Kernel::Triangle_3 triangle(to_point(mesh.points[face[0]]),
                                        to_point(mesh.points[face[k]]),
                                        to_point(mesh.points[face[k + 1]]));
      if (!triangle.is_degenerate()) data->triangles.push_back(triangle);
    }
  }
  data->tree.insert(data->triangles.begin(), data->triangles.end());
  data->tree.build();
  data_ = std::move(data);
}

RayJudge::~RayJudge() = default;

std::optional<RayJudge::Crossing> RayJudge::first_crossing(Vec3 origin, Vec3 direction) const {
  const Kernel::Point_3 from = to_point(origin);
  const Kernel::Vector_3 along(direction.x, direction.y, direction.z);
  const Kernel::Ray_3 ray(from, along);
  // Of all crossings: first_intersection of the tree compares rounded distances.
  std::vector<Tree::Primitive_id> touched;
  data_->tree.all_intersected_primitives(ray, std::back_inserter(touched));
  std::optional<Kernel::FT> first;
  const Kernel::Triangle_3* hit = nullptr;
  for (const auto& id : touched) {
    const auto crossing = CGAL::intersection(ray, *id);
    const Kernel::Point_3* const point =
        crossing ? boost::get<Kernel::Point_3>(&*crossing) : nullptr;
    if (point == nullptr) continue;  // within the triangle's plane
    const Kernel::FT time = (*point - from) * along / along.squared_length();
    if (first && *first <= time) continue;
    first = time;
    hit = &*id;
  }
  if (!first) return std::nullopt;
  const Kernel::Vector_3 n = CGAL::cross_product((*hit)[1] - (*hit)[0], (*hit)[2] - (*hit)[0]);
  const Vec3 normal =
      glm::normalize(Vec3(CGAL::to_double(n.x()), CGAL::to_double(n.y()), CGAL::to_double(n.z())));
  // Of a lazy number, to_double would be good for a few digits only.
  return Crossing{CGAL::to_double(CGAL::exact(*first)), glm::dot(normal, glm::normalize(direction)),
                  normal};
}

}  // namespace spoctree
