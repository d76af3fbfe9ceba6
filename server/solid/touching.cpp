#include "server/solid/touching.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

struct Spoke {
  std::uint32_t half_edge;
  Point apex;
  bool runs_up;
  int sector;  // 0: the first, 1: on its left, 2: opposite, 3: on its right
};

}  // namespace

std::optional<std::vector<std::array<std::uint32_t, 2>>> pair_around_edge(
    const GridMesh& mesh, const std::vector<std::uint32_t>& half_edges) {
  const auto corner = [&](std::uint32_t h, std::uint32_t further) {
    return mesh.triangles[h / 3][(h % 3 + further) % 3];
  };
  const auto at = [&](std::uint32_t v) {
    return Point(mesh.vertices[v].x, mesh.vertices[v].y, mesh.vertices[v].z);
  };
  const auto [low, high] = std::minmax({corner(half_edges[0], 0), corner(half_edges[0], 1)});
  const Point from = at(low);
  const Point to = at(high);
  std::vector<Spoke> spokes;
  for (const std::uint32_t h : half_edges) {
    Spoke spoke{h, at(corner(h, 2)), corner(h, 0) == low, 0};
    if (!spokes.empty()) {
      const auto turn = CGAL::orientation(from, to, spokes[0].apex, spoke.apex);
      spoke.sector = turn == CGAL::POSITIVE ? 1 : turn == CGAL::NEGATIVE ? 3 : 2;
    }
    spokes.push_back(spoke);
  }
  // Counter-clockwise as the edge, from its smaller to its larger point, comes at the viewer.
  std::sort(spokes.begin(), spokes.end(), [&](const Spoke& a, const Spoke& b) {
    if (a.sector != b.sector) return a.sector < b.sector;
    if (a.sector % 2 == 0) return false;
    return CGAL::orientation(from, to, a.apex, b.apex) == CGAL::POSITIVE;
  });
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const Spoke& next = spokes[i + 1 < spokes.size() ? i + 1 : 0];
    if (spokes[i].runs_up == next.runs_up) return std::nullopt;
    // Behind a triangle that runs down is material, up to the next one.
    if (!spokes[i].runs_up) pairs.push_back({spokes[i].half_edge, next.half_edge});
  }
  return pairs;
}

void separate_fans(GridMesh& mesh, const std::vector<Corners>& neighbours) {
  const auto points = static_cast<std::uint32_t>(mesh.vertices.size());
  std::vector<bool> is_seen(3 * mesh.triangles.size(), false);
  std::vector<bool> has_fan(points, false);
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    const Corners& t = mesh.triangles[h / 3];
    if (t[h % 3] < t[(h % 3 + 1) % 3]) edges.push_back({t[h % 3], t[(h % 3 + 1) % 3]});
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i] != edges[i - 1]) continue;
    mesh.touching.insert(mesh.touching.end(), edges[i].begin(), edges[i].end());
  }
  const std::vector<Corners> as_filed = mesh.triangles;
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    if (is_seen[h]) continue;
    const std::uint32_t point = as_filed[h / 3][h % 3];
    std::uint32_t name = point;
    if (has_fan[point]) {
      name = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(mesh.vertices[point]);
      mesh.copy_of.push_back(point);
      mesh.touching.insert(mesh.touching.end(), {point, name});
    }
    has_fan[point] = true;
    // Once around the point: across the edge that leaves it, to the one that leaves it there.
    for (std::uint32_t corner = h; !is_seen[corner];) {
      is_seen[corner] = true;
      mesh.triangles[corner / 3][corner % 3] = name;
      const std::uint32_t t = neighbours[corner / 3][corner % 3];
      const Corners& corners = as_filed[t];
      corner = 3 * t + (corners[0] == point ? 0 : corners[1] == point ? 1 : 2);
    }
  }
  std::sort(mesh.touching.begin(), mesh.touching.end());
  mesh.touching.erase(std::unique(mesh.touching.begin(), mesh.touching.end()), mesh.touching.end());
}

std::vector<Corners> without_copies(const GridMesh& mesh, const std::vector<Corners>& triangles) {
  std::vector<Corners> named = triangles;
  if (mesh.copy_of.empty()) return named;
  for (Corners& t : named) {
    for (std::uint32_t& v : t) v = mesh.point_of(v);
  }
  return named;
}

}  // namespace spoctree
