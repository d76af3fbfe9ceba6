#include "client/rebuild/surface_rebuilder.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "client/rebuild/chain.hpp"
#include "client/rebuild/contacts.hpp"
#include "client/rebuild/face_builder.hpp"
#include "client/rebuild/radix_sort.hpp"
#include "client/rebuild/settle_vertices.hpp"
#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

/// The shares of the steps, where there are a million faces.
constexpr double kGrowing = 0.03;
constexpr double kFindingCorners = 0.7;
constexpr double kAddingCorners = 0.02;
constexpr double kFindingLineEnds = 0.04;
constexpr double kSubdividing = 0.05;
constexpr double kJoining = 0.01;
constexpr double kSettling = 0.03;
constexpr double kResolving = 0.02;
constexpr double kBuildingFaces = 0.02;
constexpr double kFindingEdges = 0.03;

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

Surface SurfaceRebuilder::rebuild(const Octree& tree, std::uint32_t level,
                                  const ProgressShare& progress) {
  advance(tree, static_cast<std::uint32_t>(std::min<std::size_t>(level, tree.levels.size() - 1)),
          progress);
  VertexWelder welder(kWeldTolerance * 2 * std::sqrt(3.0) * tree.universe.half_side);
  std::vector<CornerCount> corners = corners_.corners();
  progress.add(kAddingCorners);
  std::vector<LineEnd> ends = find_line_ends(corners, carriers_, welder);
  corners = {};
  progress.add(kFindingLineEnds);
  Chain chain = subdivide_lines(ends, carriers_.count(), welder.vertices());
  progress.add(kSubdividing);
  ends = {};
  join_straight_edges(chain, welder.vertices().size());
  progress.add(kJoining);
  settle(chain, welder, progress);
  Surface surface;
  build_faces(chain, carriers_, sides_.of(carriers_), welder.vertices(), surface);
  progress.add(kBuildingFaces);
  drop_unused_vertices(surface, welder.vertices());
  find_edges(surface);
  progress.add(kFindingEdges);
  return surface;
}

void SurfaceRebuilder::settle(Chain& chain, VertexWelder& welder, const ProgressShare& progress) {
  // Each may leave work for the other; in practice the second round finds nothing.
  constexpr int kMaxRounds = 4;
  for (int round = 0; round < kMaxRounds; ++round) {
    const bool merged = settle_vertices(chain, carriers_, welder);
    progress.add(kSettling);
    if (round > 0 && !merged) break;
    const bool cut = resolve_contacts(chain, carriers_, welder);
    progress.add(kResolving);
    if (!merged && !cut) break;
    join_straight_edges(chain, welder.vertices().size());
  }
}

void SurfaceRebuilder::advance(const Octree& tree, std::uint32_t level,
                               const ProgressShare& progress) {
  if (level + 1 < level_count_) throw std::logic_error("rebuild: a level that has gone by");
  const std::uint32_t first = level_count_;
  for (; level_count_ <= level; ++level_count_) {
    for (const std::uint32_t plane : tree.levels[level_count_].references) {
      plane_count_ = std::max(plane_count_, plane + 1);
    }
  }
  carriers_.grow(tree, plane_count_);
  for (std::uint32_t k = first; k <= level; ++k) sides_.add(tree.levels[k], carriers_);
  progress.add(kGrowing);
  corners_.advance(tree, level, carriers_, progress.part(kFindingCorners));
}

}  // namespace spoctree
