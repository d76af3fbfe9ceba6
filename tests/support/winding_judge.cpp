#include "tests/support/winding_judge.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <vector>

#include "tests/support/cgal_mesh.hpp"

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Point to_point(Vec3 p) { return {p.x, p.y, p.z}; }

}  // namespace

struct WindingJudge::Data {
  Triangles triangles;
  Tree tree;
  Vec3 middle{0.0};
  double radius = 0;

  // Nothing if the segment meets an edge, a corner, or a triangle edge-on.
  std::optional<std::int64_t> along(const Point& from, const Point& to) const {
    std::vector<Primitive::Id> met;
    tree.all_intersected_primitives(Kernel::Segment_3(from, to), std::back_inserter(met));
    std::int64_t sum = 0;
    for (const auto& id : met) {
      const Kernel::Triangle_3& t = *id;
      const auto ends = CGAL::orientation(t[0], t[1], t[2], from);
      if (ends == CGAL::COPLANAR || CGAL::orientation(t[0], t[1], t[2], to) != -ends) return {};
      for (int i = 0; i < 3; ++i) {
        if (CGAL::orientation(from, to, t[i], t[(i + 1) % 3]) == CGAL::COPLANAR) return {};
      }
      sum += ends == CGAL::NEGATIVE ? 1 : -1;
    }
    return sum;
  }
};

WindingJudge::WindingJudge(const PlainMesh& mesh) {
  auto data = std::make_unique<Data>();
  Vec3 lower = mesh.points.at(0);
  Vec3 upper = lower;
  for (const Vec3 p : mesh.points) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  data->middle = 0.5 * lower + 0.5 * upper;
  data->radius = glm::length(upper - lower);
  for (const auto& face : mesh.faces) {
    for (const auto& [a, b, c] : triangulate_with_cgal(mesh.points, face)) {
      const Kernel::Triangle_3 triangle(to_point(mesh.points[a]), to_point(mesh.points[b]),
                                        to_point(mesh.points[c]));
      // What has no area is met edge-on or in an edge only.
      if (!triangle.is_degenerate()) data->triangles.push_back(triangle);
    }
  }
  data->tree.insert(data->triangles.begin(), data->triangles.end());
  data->tree.build();
  data_ = std::move(data);
}

WindingJudge::~WindingJudge() = default;

std::int64_t WindingJudge::winding(Vec3 point, Random& random) const {
  std::optional<std::int64_t> first;
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const Vec3 way{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (glm::length(way) < 0.1) continue;
    const Vec3 outside = data_->middle + way * (20 * data_->radius);
    const auto sum = data_->along(to_point(point), to_point(outside));
    if (!sum) continue;
    if (!first) {
      first = sum;
      continue;
    }
    if (*first != *sum) throw std::runtime_error("the surface has a border");
    return *sum;
  }
  throw std::runtime_error("every segment from the point meets an edge");
}

}  // namespace spoctree
