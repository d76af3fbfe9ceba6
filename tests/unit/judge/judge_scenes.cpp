#include "tests/unit/judge/judge_scenes.hpp"

#include <algorithm>

namespace spoctree {

void add_box(PlainMesh& mesh, Vec3 lower, Vec3 upper) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (int k = 0; k < 8; ++k) {
    mesh.points.emplace_back(k & 1 ? upper.x : lower.x, k & 2 ? upper.y : lower.y,
                             k & 4 ? upper.z : lower.z);
  }
  constexpr std::uint32_t kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : kFaces) {
    auto& corners = mesh.faces.emplace_back();
    for (const std::uint32_t corner : face) corners.push_back(first + corner);
  }
}

PlainMesh box(Vec3 lower, Vec3 upper) {
  PlainMesh mesh;
  add_box(mesh, lower, upper);
  return mesh;
}

PlainMesh turned(PlainMesh mesh) {
  for (auto& face : mesh.faces) std::reverse(face.begin(), face.end());
  return mesh;
}

PlainMesh together(PlainMesh one, const PlainMesh& other) {
  const auto first = static_cast<std::uint32_t>(one.points.size());
  one.points.insert(one.points.end(), other.points.begin(), other.points.end());
  for (auto face : other.faces) {
    for (std::uint32_t& corner : face) corner += first;
    one.faces.push_back(std::move(face));
  }
  return one;
}

PlainMesh prism(const std::vector<glm::dvec2>& outline, double low, double high,
                const std::function<Vec3(Vec3)>& place) {
  PlainMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const double z : {low, high}) {
    for (const glm::dvec2 p : outline) mesh.points.push_back(place({p, z}));
  }
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t k = 0; k < n; ++k) {
    bottom.push_back(n - 1 - k);
    top.push_back(n + k);
    const std::uint32_t next = (k + 1) % n;
    mesh.faces.push_back({k, next, n + next, n + k});
  }
  mesh.faces.push_back(bottom);
  mesh.faces.push_back(top);
  return mesh;
}

PlainMesh cells(int n, const std::function<bool(int, int, int)>& is_material) {
  PlainMesh all;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      for (int z = 0; z < n; ++z) {
        if (!is_material(x, y, z)) continue;
        const PlainMesh cell = box(Vec3(x, y, z), Vec3(x + 1, y + 1, z + 1));
        constexpr int kNext[6][3] = {{0, 0, -1}, {0, 0, 1},  {0, -1, 0},
                                     {0, 1, 0},  {-1, 0, 0}, {1, 0, 0}};
        PlainMesh open;
        open.points = cell.points;
        for (std::size_t k = 0; k < 6; ++k) {
          const int there[3] = {x + kNext[k][0], y + kNext[k][1], z + kNext[k][2]};
          const bool is_inside =
              std::all_of(there, there + 3, [&](int at) { return at >= 0 && at < n; });
          if (!is_inside || !is_material(there[0], there[1], there[2])) {
            open.faces.push_back(cell.faces[k]);
          }
        }
        all = together(std::move(all), open);
      }
    }
  }
  return all;
}

bool is_in_sponge(int x, int y, int z, int order) {
  for (int k = 0; k < order; ++k) {
    if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2) return false;
    x /= 3;
    y /= 3;
    z /= 3;
  }
  return true;
}

std::vector<DrawnLine> lines(const std::vector<std::pair<Vec3, Vec3>>& ends) {
  std::vector<DrawnLine> result;
  for (const auto& [a, b] : ends) result.push_back({a, b, false});
  return result;
}

}  // namespace spoctree
