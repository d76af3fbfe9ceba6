#include "client/rebuild/surface.hpp"

#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>

#include "client/rebuild/chain.hpp"
#include "client/rebuild/contacts.hpp"
#include "client/rebuild/corners.hpp"
#include "client/rebuild/face_builder.hpp"
#include "client/rebuild/radix_sort.hpp"
#include "client/rebuild/settle_vertices.hpp"
#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

/// Renumbers the vertices in use, in order of appearance.
void drop_unused_vertices(Surface& surface, std::span<const Vec3> positions) {
  constexpr auto kUnused = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(positions.size(), kUnused);
  for (std::uint32_t& vertex : surface.loop_vertices) {
    if (number[vertex] == kUnused) {
      number[vertex] = static_cast<std::uint32_t>(surface.vertices.size());
      surface.vertices.push_back(positions[vertex]);
    }
    vertex = number[vertex];
  }
}

/// Gathers the sides of every edge; fails if they do not balance.
void find_edges(Surface& surface) {
  struct Half {
    std::uint32_t a, b;
    Surface::Side side;
  };
  std::vector<Half> halves;
  halves.reserve(surface.loop_vertices.size());
  for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
    for (const Surface::Loop& loop : surface.loops_of(surface.faces[face])) {
      const auto vertices = surface.vertices_of(loop);
      std::uint32_t from = vertices.back();
      for (const std::uint32_t to : vertices) {
        halves.push_back({std::min(from, to), std::max(from, to), {face, from < to}});
        from = to;
      }
    }
  }
  const std::uint64_t count = surface.vertices.size();
  radix_sort(halves, count * count, [&](const Half& half) { return half.a * count + half.b; });
  surface.sides.reserve(halves.size());
  surface.edges.reserve(halves.size() / 2);
  for (std::size_t begin = 0, end = 0; begin < halves.size(); begin = end) {
    const Half& first = halves[begin];
    std::ptrdiff_t balance = 0;
    const auto first_side = static_cast<std::uint32_t>(surface.sides.size());
    for (; end < halves.size() && halves[end].a == first.a && halves[end].b == first.b; ++end) {
      balance += halves[end].side.forward ? 1 : -1;
      surface.sides.push_back(halves[end].side);
    }
    if (balance != 0) {
      const Vec3 a = surface.vertices[first.a];
      const Vec3 b = surface.vertices[first.b];
      const auto text = [](Vec3 p) {
        return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) +
               ")";
      };
      throw std::logic_error("rebuild: the surface is open along the edge " + text(a) + "-" +
                             text(b));
    }
    surface.edges.push_back(
        {first.a, first.b, first_side, static_cast<std::uint32_t>(end - begin)});
  }
}

}  // namespace

Surface rebuild_surface(const Octree& tree, std::uint32_t level) {
  Carriers carriers(tree);
  VertexWelder welder(kWeldTolerance * 2 * std::sqrt(3.0) * tree.universe.half_side);
  std::vector<LineEnd> ends = find_line_ends(find_corners(tree, level, carriers), carriers, welder);
  Chain chain = subdivide_lines(ends, carriers.count(), welder.vertices());
  join_straight_edges(chain, welder.vertices().size());
  // Each may leave work for the other; in practice the second round finds nothing.
  constexpr int kMaxRounds = 4;
  for (int round = 0; round < kMaxRounds; ++round) {
    const bool merged = settle_vertices(chain, carriers, welder);
    if (round > 0 && !merged) break;
    const bool cut = resolve_contacts(chain, carriers, welder);
    if (!merged && !cut) break;
    join_straight_edges(chain, welder.vertices().size());
  }
  Surface surface;
  build_faces(chain, carriers, find_sides(tree, level, carriers), welder.vertices(), surface);
  drop_unused_vertices(surface, welder.vertices());
  find_edges(surface);
  return surface;
}

namespace {

/// Calls visit(a, b, c) for triangles whose signed areas add up to each face's.
template <class Visit>
void visit_fans(const Surface& surface, Visit&& visit) {
  for (const Surface::Loop& loop : surface.loops) {
    const auto vertices = surface.vertices_of(loop);
    for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
      visit(surface.vertices[vertices[0]], surface.vertices[vertices[k]],
            surface.vertices[vertices[k + 1]]);
    }
  }
}

}  // namespace

double volume(const Surface& surface) {
  double six_volumes = 0;
  visit_fans(surface,
             [&](Vec3 a, Vec3 b, Vec3 c) { six_volumes += glm::dot(a, glm::cross(b, c)); });
  return six_volumes / 6;
}

double area(const Surface& surface) {
  double sum = 0;
  for (const Surface::Face& face : surface.faces) {
    Vec3 twice_area{0.0};
    for (const Surface::Loop& loop : surface.loops_of(face)) {
      const auto vertices = surface.vertices_of(loop);
      const Vec3 origin = surface.vertices[vertices[0]];
      for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
        twice_area += glm::cross(surface.vertices[vertices[k]] - origin,
                                 surface.vertices[vertices[k + 1]] - origin);
      }
    }
    sum += 0.5 * glm::length(twice_area);
  }
  return sum;
}

}  // namespace spoctree
