#include "server/solid/import_solid.hpp"

#include <cassert>
#include <utility>

#include "server/solid/facets.hpp"
#include "server/solid/grid_mesh.hpp"
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

// Reverses all triangles. Their edges 0 and 2 change places.
void turn(std::vector<Corners>& triangles, std::vector<Corners>& neighbours) {
  for (Corners& t : triangles) std::swap(t[1], t[2]);
  for (Corners& n : neighbours) std::swap(n[0], n[2]);
}

}  // namespace

Solid import_solid(const PolygonSoup& soup, std::string_view name, const ImportOptions& options) {
  assert(options.flat_tolerance >= 0 && options.flat_tolerance < 0.1);
  Solid solid;
  GridMesh mesh = place_on_grid(soup.points, name);
  triangulate(soup, mesh, solid.report);
  std::vector<Corners> neighbours = find_neighbours(mesh);

  const BoxTree boxes = box_tree_of(mesh.vertices, mesh.triangles);
  reject_self_intersections(mesh, boxes);
  const ShellJudgement shells = judge_shells(mesh, neighbours, boxes);
  if (shells.is_inside_out) turn(mesh.triangles, neighbours);
  solid.report.was_turned = shells.is_inside_out;

  solid.universe = mesh.universe;
  const double scale = solid.universe.scale();
  solid.volume = shells.volume * scale * scale * scale;
  solid.triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners& t = mesh.triangles[i];
    const Corners& n = neighbours[i];
    solid.triangles.push_back({{t[0], t[1], t[2]}, {n[0], n[1], n[2]}, 0});
  }
  solid.vertices = std::move(mesh.vertices);
  group_into_facets(solid, options.flat_tolerance * mesh.box_diagonal);
  if (options.flat_tolerance > 0) {
    const auto lost = find_lost_edge(solid);
    if (lost) {
      mesh.fail("the flat tolerance is too large for the thin part at the edge " +
                mesh.place(*lost));
    }
  }
  return solid;
}

}  // namespace spoctree
