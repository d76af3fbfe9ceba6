// What the judge of drawings says is seen is what rays find: CGAL's, from points a hair beside
// edges.
#include "tests/support/seen_edges.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "tests/support/cgal_mesh.hpp"
#include "tests/support/random.hpp"
#include "tests/unit/judge/judge_scenes.hpp"

namespace spoctree {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

/// How far beside the edge, and how far in front of it, a ray begins; scenes are a few units large.
constexpr double kBeside = 1e-9;
constexpr double kInFront = 1e-5;

Kernel::Point_3 to_point(Vec3 p) { return {p.x, p.y, p.z}; }

class Rays {
 public:
  explicit Rays(const PlainMesh& mesh) {
    for (const auto& face : mesh.faces) {
      for (const auto& corners : triangulate_with_cgal(mesh.points, face)) {
        triangles_.emplace_back(to_point(mesh.points[corners[0]]),
                                to_point(mesh.points[corners[1]]),
                                to_point(mesh.points[corners[2]]));
      }
    }
    tree_.insert(triangles_.begin(), triangles_.end());
  }

  bool sees(Vec3 point, Vec3 along, const JudgeView& view) const {
    const Vec3 viewer = view.viewer();
    const Vec3 sight = glm::normalize(view.is_perspective() ? viewer - point : viewer);
    const Vec3 beside = glm::normalize(glm::cross(along, sight));
    for (const double side : {kBeside, -kBeside}) {
      const Vec3 from = point + side * beside + kInFront * sight;
      const bool is_hidden =
          view.is_perspective()
              ? tree_.do_intersect(Kernel::Segment_3(to_point(from), to_point(viewer)))
              : tree_.do_intersect(Kernel::Ray_3(to_point(from), to_point(from + sight)));
      if (!is_hidden) return true;
    }
    return false;
  }

 private:
  Triangles triangles_;
  Tree tree_;
};

/// Tries points of every edge that are not too near to where a part ends.
std::size_t expect_agreement(const PlainMesh& mesh, const JudgeView& view, Random& random,
                             const std::string& scene) {
  const Rays rays(mesh);
  std::size_t tried = 0;
  for (const SeenEdge& edge : seen_edges(mesh, view)) {
    for (const auto* parts : {&edge.visible, &edge.hidden}) {
      for (const auto& [from, to] : *parts) {
        if (to - from < 1e-3) continue;
        for (int k = 0; k < 2; ++k) {
          const double t = from + (to - from) * random.between(0.1, 0.9);
          const Vec3 point = edge.a + t * (edge.b - edge.a);
          const bool is_seen = rays.sees(point, edge.b - edge.a, view);
          if (++tried; is_seen == (parts == &edge.visible)) continue;
          ADD_FAILURE() << scene << ": the ray from (" << point.x << ", " << point.y << ", "
                        << point.z << ") is " << (is_seen ? "free" : "not free");
        }
      }
    }
  }
  return tried;
}

Vec3 random_direction(Random& random) {
  return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

/// From anywhere, along axes and diagonals of squares, and along diagonals of cubes.
Vec3 direction_of(std::uint64_t kind, Random& random) {
  if (kind % 3 == 0) return random_direction(random);
  const auto sign = [&] { return random.chance(0.5) ? 1.0 : -1.0; };
  Vec3 direction{0.0};
  direction[static_cast<int>(random.below(3))] = sign();
  if (kind % 3 == 2) {
    for (int axis = 0; axis < 3; ++axis) {
      if (random.chance(0.6)) direction[axis] = sign();
    }
  }
  return direction;
}

PlainMesh random_cells(Random& random, int n, double density, std::vector<bool>& is_material) {
  for (int k = 0; k < n * n * n; ++k) is_material.push_back(random.chance(density));
  return cells(n, [&](int x, int y, int z) {
    return is_material[static_cast<std::size_t>((x * n + y) * n + z)];
  });
}

/// Boxes turned at random, one in each of some cells of a grid.
PlainMesh turned_boxes(Random& random) {
  PlainMesh all;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 3; ++z) {
        if (random.chance(0.3)) continue;
        const Vec3 half{random.between(0.05, 0.28), random.between(0.05, 0.28),
                        random.between(0.05, 0.28)};
        PlainMesh one = box(-half, half);
        const Vec3 u = glm::normalize(random_direction(random));
        const Vec3 v = glm::normalize(glm::cross(u, random_direction(random)));
        const glm::dmat3 turn(u, v, glm::cross(u, v));
        for (Vec3& p : one.points) p = turn * p + Vec3(x, y, z);
        all = together(std::move(all), one);
      }
    }
  }
  return all;
}

TEST(SeenEdgesProperty, AgreeWithRaysAmongCells) {
  std::size_t tried = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Random random(seed);
    std::vector<bool> is_material;
    const PlainMesh mesh = random_cells(random, 4, random.between(0.2, 0.8), is_material);
    const auto view = JudgeView::parallel(direction_of(seed, random));
    tried += expect_agreement(mesh, view, random, "cells " + std::to_string(seed));
  }
  EXPECT_GT(tried, 25000u);
}

TEST(SeenEdgesProperty, AgreeWithRaysAmongCellsInPerspective) {
  std::size_t tried = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Random random(seed);
    std::vector<bool> is_material;
    const PlainMesh mesh = random_cells(random, 4, random.between(0.2, 0.6), is_material);
    // Outside, in line with many edges; or in the middle of a free cell.
    Vec3 eye{2, -3, 2};
    Vec3 target{2, 2, 2};
    if (seed % 3 == 0) eye += random_direction(random);
    if (seed % 3 == 1) {
      std::uint32_t k = 0;
      while (is_material[k]) ++k;
      eye = {k / 16 + 0.5, k / 4 % 4 + 0.5, k % 4 + 0.5};
      target = eye + direction_of(seed, random);
    }
    const auto view = JudgeView::perspective(eye, target);
    tried += expect_agreement(mesh, view, random, "perspective " + std::to_string(seed));
  }
  EXPECT_GT(tried, 15000u);
}

TEST(SeenEdgesProperty, AgreeWithRaysAmongTurnedBoxes) {
  std::size_t tried = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Random random(seed);
    const PlainMesh mesh = turned_boxes(random);
    const Vec3 direction = direction_of(seed, random);
    const auto view = seed % 2 == 0 ? JudgeView::parallel(direction)
                                    : JudgeView::perspective(Vec3(1) + 4.0 * direction, Vec3(1));
    tried += expect_agreement(mesh, view, random, "boxes " + std::to_string(seed));
  }
  EXPECT_GT(tried, 50000u);
}

}  // namespace
}  // namespace spoctree
