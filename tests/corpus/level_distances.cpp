// A .spo file -> how far each level is from the last one, on average: what a viewer has for the
// bytes that have arrived. Distances are sampled on the rebuilt boundaries and found by CGAL.
// Usage: level_distances MODEL.spo [--samples N]
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>

#include "client/rebuild/polygon_mesh.hpp"
#include "client/rebuild/surface_rebuilder.hpp"
#include "common/program/run_program.hpp"
#include "common/wire/spo_file.hpp"
#include "tests/support/mesh_judge.hpp"

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<Vec3, Kernel>;
using Faces = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Plane2 = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>, CGAL::Exact_predicates_tag>;

struct Options {
  std::string model;
  std::size_t samples = 100000;
};

Vec3 area_vector(const std::vector<Vec3>& corners) {
  Vec3 sum{0.0};
  for (std::size_t i = 2; i < corners.size(); ++i) {
    sum += 0.5 * glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  return sum;
}

/// Adds the triangles of a polygon that may touch itself: what an odd number of its edges surround.
void add_triangles(const std::vector<Vec3>& corners, PlainMesh& mesh) {
  const Vec3 normal = area_vector(corners);
  // The two axes in which it looks largest.
  int drop = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(normal[axis]) > std::abs(normal[drop])) drop = axis;
  }
  if (normal[drop] == 0) return;
  Plane2 plane;
  std::vector<Plane2::Vertex_handle> handles;
  for (const Vec3 p : corners) {
    handles.push_back(plane.insert({p[(drop + 1) % 3], p[(drop + 2) % 3]}));
    handles.back()->info() = p;
  }
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const auto next = handles[(i + 1) % handles.size()];
    if (handles[i] != next) plane.insert_constraint(handles[i], next);
  }
  if (plane.dimension() < 2) return;
  for (const auto face : plane.all_face_handles()) face->info() = -1;
  std::vector<Plane2::Face_handle> open = {plane.infinite_face()};
  plane.infinite_face()->info() = 0;
  // Faces across an edge that is no constraint first, so that none is reached across two.
  for (std::vector<Plane2::Face_handle> beyond; !open.empty(); std::swap(open, beyond)) {
    beyond.clear();
    while (!open.empty()) {
      const auto face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto other = face->neighbor(i);
        if (other->info() >= 0) continue;
        const bool is_border = plane.is_constrained({face, i});
        if (is_border) continue;
        other->info() = face->info();
        open.push_back(other);
      }
    }
    for (const auto face : plane.all_face_handles()) {
      if (face->info() >= 0) continue;
      for (int i = 0; i < 3 && face->info() < 0; ++i) {
        if (face->neighbor(i)->info() < 0) continue;
        face->info() = face->neighbor(i)->info() + 1;
        beyond.push_back(face);
      }
      if (!beyond.empty()) break;
    }
  }
  for (const auto face : plane.finite_face_handles()) {
    if (face->info() % 2 == 0) continue;
    std::vector<std::uint32_t> triangle;
    for (int i = 0; i < 3; ++i) {
      triangle.push_back(static_cast<std::uint32_t>(mesh.points.size()));
      mesh.points.push_back(face->vertex(i)->info());
    }
    mesh.faces.push_back(std::move(triangle));
  }
}

PlainMesh boundary_of(const Octree& tree, std::uint32_t level, SurfaceRebuilder& rebuilder) {
  const PolygonMesh mesh = make_polygon_mesh(rebuilder.rebuild(tree, level), tree.universe);
  PlainMesh plain;
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < mesh.polygon_count(); ++i) {
    corners.clear();
    for (std::uint32_t c = mesh.polygon_begin[i]; c < mesh.polygon_begin[i + 1]; ++c) {
      corners.push_back(mesh.vertices[mesh.corners[c]]);
    }
    add_triangles(corners, plain);
  }
  return plain;
}

/// The mean distance of `from`'s points from `to`.
double mean_distance(const MeshJudge& from, const MeshJudge& to, std::size_t samples) {
  Random random(20261130);
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i) sum += to.distance(from.sample(random).point);
  return sum / static_cast<double>(samples);
}

/// One line a level: number, bytes up to its end, and the mean distance, that of the worse
/// direction, in % of the solid's bounding box's diagonal.
void print_distances(const Options& options) {
  const SpoFile file(options.model);
  const Octree tree = file.tree();
  const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
  SurfaceRebuilder whole;
  const MeshJudge solid(boundary_of(tree, last, whole));
  SurfaceRebuilder rebuilder;
  for (std::uint32_t k = 0; k <= last; ++k) {
    double mean = 0;
    if (k < last) {
      const MeshJudge level(boundary_of(tree, k, rebuilder));
      mean = std::max(mean_distance(level, solid, options.samples),
                      mean_distance(solid, level, options.samples));
    }
    std::printf("%u %llu %.5g\n", k,
                static_cast<unsigned long long>(file.level_bytes()[k].total_bytes),
                100 * mean / solid.diagonal());
  }
}

}  // namespace

}  // namespace spoctree

int main(int argc, char** argv) {
  CLI::App app("Says how far each level is from the solid, on average", "level_distances");
  spoctree::Options options;
  app.add_option("MODEL", options.model)->required();
  app.add_option("--samples", options.samples, "Points on each boundary");
  app.callback([&] { spoctree::print_distances(options); });
  return spoctree::run_program(app, argc, argv);
}
