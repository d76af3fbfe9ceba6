#include "server/solid/shells.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "server/solid/grid_integers.hpp"
#include "server/solid/upward_ray.hpp"

namespace spoctree {

namespace {

using Wide = boost::multiprecision::int256_t;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Six times the signed volume between a triangle and the origin, in units of 2^-156.
Wide volume_below(const GridMesh& mesh, const Corners& t) {
  const GridPoint a = to_grid_integers(mesh.vertices[t[0]]);
  const AreaVector area =
      area_vector(a, to_grid_integers(mesh.vertices[t[1]]), to_grid_integers(mesh.vertices[t[2]]));
  return Wide(area[0]) * a[0] + Wide(area[1]) * a[1] + Wide(area[2]) * a[2];
}

struct Shell {
  std::uint32_t first_triangle = 0;
  Wide volume = 0;
};

// For each shell a point that is on no other: they may touch in edges and points.
std::vector<Vec3> find_points_apart(const GridMesh& mesh,
                                    const std::vector<std::uint32_t>& shell_of,
                                    std::size_t shells) {
  constexpr std::uint32_t kSeveral = kNone - 1;
  std::vector<std::uint32_t> shell_at(mesh.vertices.size(), kNone);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      std::uint32_t& at = shell_at[mesh.point_of(v)];
      at = at == kNone || at == shell_of[t] ? shell_of[t] : kSeveral;
    }
  }
  std::vector<Vec3> points(shells);
  std::vector<double> rank(shells, -1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    double& best = rank[shell_of[t]];
    if (std::isinf(best)) continue;
    Vec3& point = points[shell_of[t]];
    const auto& [a, b, c] = mesh.triangles[t];
    for (const std::uint32_t v : {a, b, c}) {
      if (shell_at[mesh.point_of(v)] == kSeveral) continue;
      point = mesh.vertices[v];
      best = std::numeric_limits<double>::infinity();
      break;
    }
    // All corners may be shared: then the middle of the largest triangle, which nothing touches.
    const Vec3 area =
        glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
    if (std::isinf(best) || glm::dot(area, area) <= best) continue;
    best = glm::dot(area, area);
    point = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
  }
  return points;
}

std::vector<Shell> find_shells(const GridMesh& mesh, const std::vector<Corners>& neighbours,
                               std::vector<std::uint32_t>& shell_of) {
  std::vector<Shell> shells;
  shell_of.assign(mesh.triangles.size(), kNone);
  std::vector<std::uint32_t> reached;
  for (std::uint32_t first = 0; first < mesh.triangles.size(); ++first) {
    if (shell_of[first] != kNone) continue;
    const auto number = static_cast<std::uint32_t>(shells.size());
    Shell shell{first, 0};
    shell_of[first] = number;
    reached.assign(1, first);
    while (!reached.empty()) {
      const std::uint32_t t = reached.back();
      reached.pop_back();
      shell.volume += volume_below(mesh, mesh.triangles[t]);
      for (const std::uint32_t n : neighbours[t]) {
        if (shell_of[n] != kNone) continue;
        shell_of[n] = number;
        reached.push_back(n);
      }
    }
    shells.push_back(shell);
  }
  return shells;
}

// Whether the shell lies within an odd number of others, as this point of it does.
bool is_cavity(const GridMesh& mesh, const BoxTree& boxes,
               const std::vector<std::uint32_t>& shell_of, std::uint32_t self, Vec3 start) {
  const UpwardRay ray(start);
  bool is_inside = false;
  boxes.visit_boxes_above(start, [&](std::uint32_t t) {
    if (shell_of[t] == self) return;
    const auto& [a, b, c] = mesh.triangles[t];
    if (ray.meets(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]) ==
        UpwardRay::Meets::Crosses) {
      is_inside = !is_inside;
    }
  });
  return is_inside;
}

}  // namespace

ShellJudgement judge_shells(const GridMesh& mesh, const std::vector<Corners>& neighbours,
                            const BoxTree& boxes) {
  std::vector<std::uint32_t> shell_of;
  const std::vector<Shell> shells = find_shells(mesh, neighbours, shell_of);
  ShellJudgement judgement;
  judgement.shells = shells.size();
  Wide volume = 0;
  const std::vector<Vec3> points =
      shells.size() > 1 ? find_points_apart(mesh, shell_of, shells.size()) : std::vector<Vec3>{};
  for (std::uint32_t s = 0; s < shells.size(); ++s) {
    const Shell& shell = shells[s];
    volume += shell.volume;
    const bool bounds_cavity = shells.size() > 1 && is_cavity(mesh, boxes, shell_of, s, points[s]);
    if ((shell.volume < 0) == bounds_cavity) continue;
    judgement.wrong.push_back(shell.first_triangle);
  }
  judgement.volume = static_cast<double>(volume.convert_to<long double>() / 6 * 0x1p-156L);
  return judgement;
}

}  // namespace spoctree
