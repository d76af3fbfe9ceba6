#include "server/solid/facets.hpp"

#include <algorithm>

#include "server/solid/flat_surface.hpp"
#include "server/solid/planar_patch.hpp"

namespace spoctree {

namespace {

void collect_facet_vertices(Solid& solid, std::size_t facets) {
  std::vector<std::uint32_t> begin(facets + 1, 0);
  for (const SolidTriangle& t : solid.triangles) begin[t.facet + 1] += 3;
  for (std::size_t f = 0; f < facets; ++f) begin[f + 1] += begin[f];
  std::vector<std::uint32_t> corners(begin.back());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (const SolidTriangle& t : solid.triangles) {
    for (const std::uint32_t v : t.vertex) corners[next[t.facet]++] = v;
  }
  solid.facet_vertex_begin.assign(1, 0);
  solid.facet_vertices.clear();
  for (std::size_t f = 0; f < facets; ++f) {
    const auto first = corners.begin() + begin[f];
    const auto last = corners.begin() + begin[f + 1];
    std::sort(first, last);
    solid.facet_vertices.insert(solid.facet_vertices.end(), first, std::unique(first, last));
    solid.facet_vertex_begin.push_back(static_cast<std::uint32_t>(solid.facet_vertices.size()));
  }
}

// Gives every triangle its facet; returns for each facet the number of its plane.
std::vector<std::uint32_t> connect(Solid& solid, const std::vector<std::uint32_t>& number_of) {
  std::vector<std::uint32_t> plane_of_facet;
  for (SolidTriangle& t : solid.triangles) t.facet = kNone;
  std::vector<std::uint32_t> reached;
  for (std::uint32_t first = 0; first < solid.triangles.size(); ++first) {
    if (solid.triangles[first].facet != kNone) continue;
    const auto facet = static_cast<std::uint32_t>(plane_of_facet.size());
    plane_of_facet.push_back(number_of[first]);
    solid.triangles[first].facet = facet;
    reached.assign(1, first);
    while (!reached.empty()) {
      const std::uint32_t t = reached.back();
      reached.pop_back();
      for (const std::uint32_t n : solid.triangles[t].neighbour) {
        if (solid.triangles[n].facet != kNone || number_of[n] != number_of[t]) continue;
        solid.triangles[n].facet = facet;
        reached.push_back(n);
      }
    }
  }
  return plane_of_facet;
}

std::vector<GridPoint> points_of(const Solid& solid) {
  std::vector<GridPoint> points;
  points.reserve(solid.vertices.size());
  for (const Vec3 v : solid.vertices) points.push_back(to_grid_integers(v));
  return points;
}

}  // namespace

void group_into_facets(Solid& solid, std::span<const GridPlane> planes) {
  const NumberedPlanes numbered = number_planes(planes);
  solid.facet_plane = connect(solid, numbered.number_of);
  collect_facet_vertices(solid, solid.facet_plane.size());

  const std::vector<GridPoint> points = points_of(solid);
  std::vector<HeightRange> ranges(numbered.first.size());
  for (std::uint32_t t = 0; t < solid.triangles.size(); ++t) {
    for (const std::uint32_t v : solid.triangles[t].vertex) {
      ranges[numbered.number_of[t]].add(planes[t].height(points[v]));
    }
  }
  solid.planes.clear();
  solid.planes.reserve(ranges.size());
  Int128 largest_gap = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    GridPlane plane = planes[numbered.first[i]];
    plane.offset = offset_above(ranges[i].highest);
    const Int128 offset = static_cast<Int128>(plane.offset) << kGridBits;
    largest_gap = std::max(largest_gap, offset - ranges[i].lowest);
    solid.planes.push_back(plane.to_plane());
  }
  // Rounded up, twice at most: it is a bound.
  solid.largest_incidence_gap = static_cast<double>(largest_gap) * 0x1p-104 * (1 + 0x1p-50);
}

void group_into_facets(Solid& solid) {
  std::vector<Corners> triangles;
  triangles.reserve(solid.triangles.size());
  for (const SolidTriangle& t : solid.triangles) {
    triangles.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
  }
  group_into_facets(solid, planes_of(triangles, points_of(solid)));
}

}  // namespace spoctree
