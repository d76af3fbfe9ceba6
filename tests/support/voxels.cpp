#include "tests/support/voxels.hpp"

#include <array>
#include <map>

namespace spoctree {

namespace {

enum class Filling { None, Some, All };

Filling filling(const Voxels& voxels, std::array<int, 3> lower, int size) {
  bool any_in = false;
  bool any_out = false;
  for (int x = lower[0]; x < lower[0] + size; ++x) {
    for (int y = lower[1]; y < lower[1] + size; ++y) {
      for (int z = lower[2]; z < lower[2] + size; ++z) (voxels(x, y, z) ? any_in : any_out) = true;
    }
  }
  if (any_in && any_out) return Filling::Some;
  return any_in ? Filling::All : Filling::None;
}

}  // namespace

Octree tree_of(const Voxels& voxels, bool merged) {
  Octree tree;
  std::vector<std::array<int, 3>> cells{{0, 0, 0}};
  for (int size = voxels.side(); !cells.empty(); size /= 2) {
    Level level;
    std::vector<std::array<int, 3>> next;
    for (const auto& cell : cells) {
      const Filling filled = filling(voxels, cell, size);
      if (filled == Filling::Some || (!merged && size > 1 && filled == Filling::All)) {
        level.append(NodeKind::Grey, {});
        for (int octant = 0; octant < 8; ++octant) {
          next.push_back({cell[0] + (octant & 1) * size / 2, cell[1] + (octant >> 1 & 1) * size / 2,
                          cell[2] + (octant >> 2 & 1) * size / 2});
        }
      } else {
        level.append(filled == Filling::All ? NodeKind::Black : NodeKind::White, {});
      }
    }
    tree.levels.push_back(std::move(level));
    cells = std::move(next);
  }
  return tree;
}

Surface surface_of(const Voxels& voxels, double half_side) {
  Surface surface;
  const int n = voxels.side();
  using Point = std::array<int, 3>;
  std::map<Point, std::uint32_t> vertices;
  std::map<std::array<std::uint32_t, 2>, std::vector<Surface::Side>> edges;
  const auto vertex = [&](Point p) {
    const auto [entry, is_new] =
        vertices.try_emplace(p, static_cast<std::uint32_t>(surface.vertices.size()));
    if (is_new) {
      surface.vertices.push_back((2.0 * Vec3{p[0], p[1], p[2]} / static_cast<double>(n) - 1.0) *
                                 half_side);
    }
    return entry->second;
  };
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      for (int z = 0; z < n; ++z) {
        if (!voxels(x, y, z)) continue;
        for (int axis = 0; axis < 3; ++axis) {
          for (const int upper : {0, 1}) {
            Point beside{x, y, z};
            beside[static_cast<std::size_t>(axis)] += upper == 1 ? 1 : -1;
            if (voxels(beside[0], beside[1], beside[2])) continue;
            Point corner{x, y, z};
            corner[static_cast<std::size_t>(axis)] += upper;
            const auto u = static_cast<std::size_t>((axis + 1) % 3);
            const auto v = static_cast<std::size_t>((axis + 2) % 3);
            Point ring[4] = {corner, corner, corner, corner};
            ++ring[1][u];
            ++ring[2][u], ++ring[2][v];
            ++ring[3][v];
            if (upper == 0) std::swap(ring[1], ring[3]);
            const auto wall = PlaneRef::of_wall(
                axis, static_cast<std::uint32_t>(corner[static_cast<std::size_t>(axis)])
                          << (kMaxDepth - voxels.depth));
            const auto face = static_cast<std::uint32_t>(surface.faces.size());
            surface.faces.push_back({upper == 1 ? wall : wall.flipped(),
                                     static_cast<std::uint32_t>(surface.loops.size()), 1});
            surface.loops.push_back({static_cast<std::uint32_t>(surface.loop_vertices.size()), 4});
            for (int k = 0; k < 4; ++k) {
              const std::uint32_t a = vertex(ring[k]);
              const std::uint32_t b = vertex(ring[(k + 1) % 4]);
              surface.loop_vertices.push_back(a);
              edges[{std::min(a, b), std::max(a, b)}].push_back({face, a < b});
            }
          }
        }
      }
    }
  }
  for (const auto& [ends, sides] : edges) {
    const bool is_flat = sides.size() == 2 &&
                         surface.faces[sides[0].face].plane == surface.faces[sides[1].face].plane;
    if (is_flat) continue;
    surface.edges.push_back({ends[0], ends[1], static_cast<std::uint32_t>(surface.sides.size()),
                             static_cast<std::uint32_t>(sides.size())});
    surface.sides.insert(surface.sides.end(), sides.begin(), sides.end());
  }
  return surface;
}

bool in_menger_sponge(int x, int y, int z, int order) {
  for (int k = 0; k < order; ++k, x /= 3, y /= 3, z /= 3) {
    if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2) return false;
  }
  return x == 0 && y == 0 && z == 0;
}

}  // namespace spoctree
