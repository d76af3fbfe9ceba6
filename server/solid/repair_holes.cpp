// CGAL's own checks stay on in this file: what goes into it is broken by definition, and a
// condition that fails must be an exception here, whatever the build.
#define CGAL_DEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
// Above: before anything that may include CGAL without its checks.

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "server/solid/face_groups.hpp"
#include "server/solid/repair.hpp"
#include "server/solid/repair_debris.hpp"
#include "server/solid/repair_holes.hpp"
#include "server/solid/soup_edges.hpp"
#include "server/solid/soup_surfaces.hpp"

namespace spoctree {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// CGAL's algorithm without the Delaunay triangulation is cubic.
constexpr std::size_t kMostCubicEdges = 50;

// A border edge seen from the hole: against the direction of its face.
struct BorderEdge {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t opposite;  // a third corner of the face
  std::uint32_t face;
};

using Patch = std::vector<std::vector<std::uint32_t>>;  // faces, as point numbers
using Loop = std::vector<BorderEdge>;

std::vector<BorderEdge> find_border(const PolygonSoup& soup, std::span<const SoupSide> sides,
                                    const SoupSurfaces& surfaces) {
  std::vector<BorderEdge> border;
  for_each_edge(sides, [&](std::span<const SoupSide> edge) {
    if (edge.size() != 1) return;
    if (surfaces.list[surfaces.of_face[edge[0].face]].unbalanced_edges > 0) return;
    const auto face = soup.face(edge[0].face);
    const std::size_t i = edge[0].corner - soup.first_corner[edge[0].face];
    const std::uint32_t a = face[i];
    const std::uint32_t b = face[(i + 1) % face.size()];
    border.push_back({b, a, face[(i + 2) % face.size()], edge[0].face});
  });
  std::stable_sort(border.begin(), border.end(),
                   [](const BorderEdge& x, const BorderEdge& y) { return x.from < y.from; });
  return border;
}

// Walks along the border; where the walk meets itself, a loop is cut off. Every vertex has as many
// border edges in as out, so that no walk ends anywhere else.
std::vector<Loop> find_loops(const std::vector<BorderEdge>& border, std::size_t points) {
  std::vector<std::uint32_t> next(points + 1, 0);  // the first unused edge from each point
  for (const BorderEdge& edge : border) ++next[edge.from + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  const std::vector<std::uint32_t> begin = next;
  std::vector<std::uint32_t> place(points, kNone);  // in the walk
  std::vector<Loop> loops;
  for (std::uint32_t start = 0; start < points; ++start) {
    while (next[start] < begin[start + 1]) {
      Loop walk;
      std::uint32_t at = start;
      place[at] = 0;
      do {
        if (next[at] == begin[at + 1]) return {};  // not balanced: a precondition is broken
        walk.push_back(border[next[at]++]);
        at = walk.back().to;
        if (place[at] == kNone) {
          place[at] = static_cast<std::uint32_t>(walk.size());
          continue;
        }
        const auto cut = walk.begin() + place[at];
        loops.emplace_back(cut, walk.end());
        for (auto edge = cut + 1; edge < walk.end(); ++edge) place[edge->from] = kNone;
        walk.erase(cut, walk.end());
      } while (!walk.empty());
      place[start] = kNone;
    }
  }
  return loops;
}

double diagonal(std::span<const glm::dvec3> points) {
  glm::dvec3 lower = points[0];
  glm::dvec3 upper = points[0];
  for (const glm::dvec3& p : points) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  return glm::length(upper - lower);
}

// The largest distance of a corner from the mean plane of the loop.
double unevenness(std::span<const glm::dvec3> points) {
  glm::dvec3 middle{0.0};
  for (const glm::dvec3& p : points) middle += p / static_cast<double>(points.size());
  glm::dvec3 normal{0.0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    normal += glm::cross(points[i] - middle, points[(i + 1) % points.size()] - middle);
  }
  const double length = glm::length(normal);
  if (!(length > 0)) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (const glm::dvec3& p : points) {
    largest = std::max(largest, std::abs(glm::dot(normal, p - middle)) / length);
  }
  return largest;
}

std::vector<glm::dvec3> points_of(const Loop& loop, const PolygonSoup& soup) {
  std::vector<glm::dvec3> points;
  points.reserve(loop.size());
  for (const BorderEdge& edge : loop) points.push_back(soup.points[edge.from]);
  return points;
}

Hole describe(const Loop& loop, const PolygonSoup& soup) {
  const std::vector<glm::dvec3> points = points_of(loop, soup);
  Hole hole;
  hole.first_edge = {kNone, kNone};
  for (const BorderEdge& edge : loop) {
    hole.first_edge = std::min(hole.first_edge, {edge.from, edge.to});
  }
  hole.edges = loop.size();
  hole.size = diagonal(points);
  hole.is_flat = unevenness(points) <= kFlatHole * hole.size;
  return hole;
}

// Empty if CGAL finds none.
Patch triangulate(const Loop& loop, const PolygonSoup& soup) {
  std::vector<Point> points;
  std::vector<Point> opposite;
  for (const BorderEdge& edge : loop) {
    const glm::dvec3 p = soup.points[edge.from];
    const glm::dvec3 q = soup.points[edge.opposite];
    points.emplace_back(p.x, p.y, p.z);
    opposite.emplace_back(q.x, q.y, q.z);
  }
  std::vector<CGAL::Triple<int, int, int>> triangles;
  try {
    // Not by CGAL's triangulation in the plane of a flat hole: its test for crossing edges is not
    // exact, and where it errs, constraints that cross end in a segmentation fault (5.5.1).
    PMP::triangulate_hole_polyline(points, opposite, std::back_inserter(triangles),
                                   CGAL::parameters::use_delaunay_triangulation(true)
                                       .use_2d_constrained_delaunay_triangulation(false)
                                       .do_not_use_cubic_algorithm(loop.size() > kMostCubicEdges));
  } catch (const CGAL::Failure_exception&) {
    return {};
  }
  Patch patch;
  for (const auto& t : triangles) {
    const auto corner = [&](int i) { return loop[static_cast<std::size_t>(i) % loop.size()].from; };
    patch.push_back({corner(t.first), corner(t.second), corner(t.third)});
  }
  return patch;
}

// Whether the hole is all around a single face, which a patch would only double.
bool is_back_of_face(const Loop& loop, const PolygonSoup& soup) {
  return soup.face(loop[0].face).size() == loop.size() &&
         std::all_of(loop.begin(), loop.end(),
                     [&](const BorderEdge& edge) { return edge.face == loop[0].face; });
}

Patch one_polygon(const Loop& loop) {
  Patch patch(1);
  for (const BorderEdge& edge : loop) patch[0].push_back(edge.from);
  return patch;
}

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

// Whether the patch fills the loop: it is one polygon, or its triangles' sides are the loop's edges
// and, in pairs, edges that are new.
bool is_good(const Patch& patch, const Loop& loop, std::set<std::uint64_t>& edges_in_use) {
  if (patch.size() == 1 && patch[0].size() == loop.size() && loop.size() > 3) return true;
  if (patch.size() + 2 != loop.size()) return false;
  std::set<std::uint64_t> of_loop;
  for (const BorderEdge& edge : loop) of_loop.insert(edge_key(edge.from, edge.to));
  std::set<std::uint64_t> diagonals;
  for (const auto& t : patch) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t key = edge_key(t[i], t[(i + 1) % 3]);
      if (of_loop.contains(key)) continue;
      if (edges_in_use.contains(key)) return false;
      diagonals.insert(key);
    }
  }
  if (diagonals.size() + 3 != loop.size()) return false;
  edges_in_use.merge(diagonals);
  return true;
}

// Of each surface, whether filling its holes would make it up rather than complete it. Surfaces
// with a hole in common are looked at together.
std::vector<bool> find_scraps(const SoupSurfaces& surfaces, const std::vector<Loop>& loops) {
  FaceGroups groups(surfaces.list.size());
  for (const Loop& loop : loops) {
    for (const BorderEdge& edge : loop) {
      groups.join(surfaces.of_face[loop[0].face], surfaces.of_face[edge.face]);
    }
  }
  std::vector<SoupSurface> sums(surfaces.list.size());
  double whole_area = 0;
  for (std::uint32_t i = 0; i < surfaces.list.size(); ++i) {
    SoupSurface& sum = sums[groups.group_of(i)];
    sum.triangles += surfaces.list[i].triangles;
    sum.area += surfaces.list[i].area;
    sum.area_vector += surfaces.list[i].area_vector;
    whole_area += surfaces.list[i].area;
  }
  std::vector<std::size_t> triangles_missing(surfaces.list.size(), 0);
  for (const Loop& loop : loops) {
    triangles_missing[groups.group_of(surfaces.of_face[loop[0].face])] += loop.size() - 2;
  }
  std::vector<bool> is_scrap(surfaces.list.size(), false);
  for (std::uint32_t i = 0; i < surfaces.list.size(); ++i) {
    const std::uint32_t group = groups.group_of(i);
    const SoupSurface& sum = sums[group];
    is_scrap[i] = triangles_missing[group] > 0 &&
                  (triangles_missing[group] >= sum.triangles || sum.flatness() > kFlatPiece ||
                   (sum.flatness() > kFlatScrap && sum.area <= kLargestDebris * whole_area));
  }
  return is_scrap;
}

}  // namespace

FilledHoles fill_holes(PolygonSoup& soup) {
  FilledHoles holes;
  const std::vector<SoupSide> sides = sides_by_edge(soup);
  const SoupSurfaces surfaces = find_surfaces(soup, sides, Connection::AnyEdge);
  const std::vector<BorderEdge> border = find_border(soup, sides, surfaces);
  if (border.empty()) return holes;
  const std::vector<Loop> loops = find_loops(border, soup.points.size());
  const std::vector<bool> is_of_scrap = find_scraps(surfaces, loops);
  holes.is_scrap.resize(soup.face_count());
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    holes.is_scrap[f] = is_of_scrap[surfaces.of_face[f]];
  }
  // Edges between points of the border: a patch must not use them again.
  std::vector<bool> is_on_border(soup.points.size(), false);
  for (const BorderEdge& edge : border) is_on_border[edge.from] = true;
  std::set<std::uint64_t> edges_in_use;
  for_each_edge(sides, [&](std::span<const SoupSide> edge) {
    if (is_on_border[edge[0].low] && is_on_border[edge[0].high]) {
      edges_in_use.insert(edge_key(edge[0].low, edge[0].high));
    }
  });

  holes.whole = diagonal(soup.points);
  std::size_t squares_left = kMostHoleEdges * kMostHoleEdges;
  for (const Loop& loop : loops) {
    const Hole hole = describe(loop, soup);
    if (is_of_scrap[surfaces.of_face[loop[0].face]]) {
      holes.of_scraps.add(hole);
      continue;
    }
    const bool by_polygon = hole.is_flat && hole.edges > kMostFlatHoleEdges;
    const std::size_t square =
        by_polygon || hole.edges <= kFewHoleEdges ? 0 : hole.edges * hole.edges;
    if (square > squares_left) {
      holes.too_long.add(hole);
      continue;
    }
    if (!hole.is_flat && hole.edges > kFewHoleEdges && !(hole.size <= kLargestHole * holes.whole)) {
      holes.too_large.add(hole);
      continue;
    }
    squares_left -= square;
    const Patch patch = by_polygon ? one_polygon(loop) : triangulate(loop, soup);
    if (is_back_of_face(loop, soup) || !is_good(patch, loop, edges_in_use)) {
      holes.unfillable.add(hole);
      continue;
    }
    for (const auto& face : patch) {
      soup.corners.insert(soup.corners.end(), face.begin(), face.end());
      soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
    holes.faces += patch.size();
    holes.filled.add(hole);
    if (hole.size > holes.largest.size) holes.largest = hole;
  }
  return holes;
}

}  // namespace spoctree
