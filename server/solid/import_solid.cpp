#include "server/solid/import_solid.hpp"

#include <cassert>
#include <utility>

#include "server/solid/facets.hpp"
#include "server/solid/grid_mesh.hpp"
#include "server/solid/merge_faces.hpp"
#include "server/solid/neighbours.hpp"
#include "server/solid/self_intersections.hpp"
#include "server/solid/shells.hpp"
#include "server/solid/triangulate.hpp"

namespace spoctree {

namespace {

void reject_self_intersections(const GridMesh& mesh, const BoxTree& boxes) {
  const SelfIntersections found = find_self_intersections(mesh.vertices, mesh.triangles, boxes);
  if (found.count == 0) return;
  // The coordinates of the file may be finer than the grid; then say whose fault it is.
  const bool is_by_rounding =
      find_self_intersections(mesh.points, mesh.triangles, box_tree_of(mesh.points, mesh.triangles))
          .count == 0;
  mesh.fail("self-intersecting: " +
            (found.count == kMostSelfIntersections ? std::string("at least ") : std::string()) +
            counted(found.count, "pair") + " of triangles meet" +
            (is_by_rounding ? " once points are rounded to 2^-52 of the extent" : "") +
            ", first at " + mesh.place(mesh.triangles[found.first[0]]) + " and " +
            mesh.place(mesh.triangles[found.first[1]]));
}

ShellJudgement judge_nesting(const GridMesh& mesh, const std::vector<Corners>& neighbours,
                             const BoxTree& boxes) {
  const ShellJudgement shells = judge_shells(mesh, neighbours, boxes);
  if (shells.wrong > 0 && !shells.is_inside_out()) {
    mesh.fail("not consistently oriented: " + std::to_string(shells.wrong) + " of " +
              std::to_string(shells.shells) +
              " shells face the wrong way for how they nest, the first has a face at " +
              mesh.place(mesh.triangles[shells.first_wrong]));
  }
  return shells;
}

// Reverses all triangles. Their edges 0 and 2 change places.
void turn(std::vector<Corners>& triangles, std::vector<Corners>& neighbours,
          ShellJudgement& shells) {
  for (Corners& t : triangles) std::swap(t[1], t[2]);
  for (Corners& n : neighbours) std::swap(n[0], n[2]);
  shells.wrong = 0;
  shells.volume = -shells.volume;
}

Solid make_solid(PlanarSurface surface, SolidReport report) {
  Solid solid;
  solid.report = std::move(report);
  solid.universe = surface.mesh.universe;
  const double scale = solid.universe.scale();
  solid.volume = surface.shells.volume * scale * scale * scale;
  solid.report.planes_before_merging = surface.planes_before_merging;
  solid.report.largest_move = surface.largest_move * scale;
  solid.triangles.reserve(surface.mesh.triangles.size());
  for (std::size_t i = 0; i < surface.mesh.triangles.size(); ++i) {
    const Corners& t = surface.mesh.triangles[i];
    const Corners& n = surface.neighbours[i];
    solid.triangles.push_back({{t[0], t[1], t[2]}, {n[0], n[1], n[2]}, 0});
  }
  solid.vertices = std::move(surface.mesh.vertices);
  group_into_facets(solid, surface.planes);
  return solid;
}

}  // namespace

Solid import_solid(const PolygonSoup& soup, std::string_view name, const ImportOptions& options) {
  assert(options.flat_tolerance >= 0 && options.flat_tolerance < 0.1);
  SolidReport report;
  GridMesh mesh = place_on_grid(soup.points, name);
  triangulate(soup, mesh, report);
  std::vector<Corners> neighbours = find_neighbours(mesh);

  const BoxTree boxes = box_tree_of(mesh.vertices, mesh.triangles);
  reject_self_intersections(mesh, boxes);
  ShellJudgement shells = judge_nesting(mesh, neighbours, boxes);
  report.was_turned = shells.is_inside_out();
  if (report.was_turned) turn(mesh.triangles, neighbours, shells);

  const double tolerance = options.flat_tolerance * mesh.box_diagonal;
  return make_solid(merge_faces(std::move(mesh), std::move(neighbours), boxes, shells, tolerance),
                    std::move(report));
}

}  // namespace spoctree
