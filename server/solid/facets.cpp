#include "server/solid/facets.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "server/solid/grow_patches.hpp"
#include "server/solid/share_planes.hpp"

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

}  // namespace

void group_into_facets(Solid& solid, double tolerance) {
  std::vector<GridPoint> points;
  points.reserve(solid.vertices.size());
  for (const Vec3 v : solid.vertices) points.push_back(to_grid_integers(v));

  const GrownPatches grown = grow_patches(solid.triangles, points, tolerance);
  collect_facet_vertices(solid, grown.patches.size());
  SharedPlanes shared = share_planes(grown.patches, solid, points, tolerance);
  solid.facet_plane = std::move(shared.plane_of_patch);

  solid.planes.clear();
  Int128 largest_gap = 0;
  for (SharedPlane& p : shared.planes) {
    p.plane.offset = offset_above(p.range.highest);
    const Int128 offset = static_cast<Int128>(p.plane.offset) << kGridBits;
    largest_gap = std::max(largest_gap, offset - p.range.lowest);
    solid.planes.push_back(p.plane.to_plane());
  }
  // Rounded up, twice at most: it is a bound.
  solid.largest_incidence_gap = static_cast<double>(largest_gap) * 0x1p-104 * (1 + 0x1p-50);
  solid.report.planes_before_merging = grown.distinct_triangle_planes;
  solid.report.largest_merge_distance = solid.largest_incidence_gap * solid.universe.scale();
}

std::optional<std::array<std::uint32_t, 2>> find_lost_edge(const Solid& solid) {
  for (const SolidTriangle& t : solid.triangles) {
    const Vec3 here = solid.planes[solid.facet_plane[t.facet]].normal;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t across = solid.triangles[t.neighbour[i]].facet;
      const Vec3 there = solid.planes[solid.facet_plane[across]].normal;
      // Both planes pass the edge within the gap; what is left to know is the angle between them.
      if (glm::dot(here, there) < 0 &&
          2 * solid.largest_incidence_gap > kMostEdgeShift * glm::length(glm::cross(here, there))) {
        return std::array{t.vertex[i], t.vertex[(i + 1) % 3]};
      }
    }
  }
  return std::nullopt;
}

}  // namespace spoctree
