#include "server/solid/mend_folds.hpp"

#include <algorithm>
#include <cstdlib>

namespace spoctree {

namespace {

// Edges are not turned at vertices with more triangles: finding out what they are joined to already
// would take too long.
constexpr int kMostTriangles = 1000;

bool is_upright(const SettledSurface& surface, const GridPoint& normal, const Corners& t) {
  const auto axis = static_cast<std::size_t>(
      std::max_element(normal.begin(), normal.end(),
                       [](std::int64_t p, std::int64_t q) { return std::abs(p) < std::abs(q); }) -
      normal.begin());
  const Int128 area =
      area_vector(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]])[axis];
  return normal[axis] > 0 ? area > 0 : area < 0;
}

std::uint32_t edge_from(const Corners& triangle, std::uint32_t vertex) {
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}

bool is_joined(const SettledSurface& surface, std::uint32_t triangle, std::uint32_t from,
               std::uint32_t to) {
  int seen = 0;
  bool found = false;
  visit_fan(surface.triangles, surface.neighbours, triangle, from, [&](std::uint32_t t) {
    const Corners& c = surface.triangles[t];
    found = found || c[0] == to || c[1] == to || c[2] == to;
    ++seen;
  });
  return found || seen > kMostTriangles;
}

// Turns edge `i` of triangle `t` if that makes more triangles upright; false if not.
bool turn_edge(SettledSurface& surface, std::uint32_t t, std::uint32_t i, std::uint32_t& other) {
  Corners& a = surface.triangles[t];
  const std::uint32_t u = surface.neighbours[t][i];
  const std::uint32_t group = surface.groups->of_triangle[t];
  if (surface.groups->of_triangle[u] != group) return false;
  Corners& b = surface.triangles[u];
  const std::uint32_t p = a[i];
  const std::uint32_t q = a[(i + 1) % 3];
  const std::uint32_t r = a[(i + 2) % 3];
  const std::uint32_t j = edge_from(b, q);
  const std::uint32_t s = b[(j + 2) % 3];
  const Corners first = {p, s, r};
  const Corners second = {s, q, r};
  const GridPoint& normal = surface.groups->groups[group].plane.normal;
  const int upright_before = is_upright(surface, normal, a) + is_upright(surface, normal, b);
  const int upright_after =
      is_upright(surface, normal, first) + is_upright(surface, normal, second);
  if (upright_after <= upright_before || is_joined(surface, t, r, s)) return false;

  const Corners beside_a = surface.neighbours[t];
  const Corners beside_b = surface.neighbours[u];
  const std::uint32_t beside_ps = beside_b[(j + 1) % 3];
  const std::uint32_t beside_qr = beside_a[(i + 1) % 3];
  const std::uint32_t edge_sp = edge_from(surface.triangles[beside_ps], s);
  const std::uint32_t edge_rq = edge_from(surface.triangles[beside_qr], r);
  a = first;
  b = second;
  surface.neighbours[t] = {beside_ps, u, beside_a[(i + 2) % 3]};
  surface.neighbours[u] = {beside_b[(j + 2) % 3], beside_qr, t};
  surface.neighbours[beside_ps][edge_sp] = t;
  surface.neighbours[beside_qr][edge_rq] = u;
  other = u;
  return true;
}

double squared_length(const SettledSurface& surface, std::uint32_t p, std::uint32_t q) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto d = static_cast<double>(surface.points[q][i] - surface.points[p][i]);
    sum += d * d;
  }
  return sum;
}

bool mend(SettledSurface& surface, std::uint32_t t, std::uint32_t& other) {
  const Corners c = surface.triangles[t];
  std::array<std::pair<double, std::uint32_t>, 3> edges;
  for (std::uint32_t i = 0; i < 3; ++i) {
    edges[i] = {-squared_length(surface, c[i], c[(i + 1) % 3]), i};
  }
  std::sort(edges.begin(), edges.end());
  return std::any_of(edges.begin(), edges.end(),
                     [&](const auto& edge) { return turn_edge(surface, t, edge.second, other); });
}

}  // namespace

bool is_upright(const SettledSurface& surface, std::uint32_t triangle) {
  const FlatGroup& group = surface.groups->groups[surface.groups->of_triangle[triangle]];
  return is_upright(surface, group.plane.normal, surface.triangles[triangle]);
}

std::vector<std::uint32_t> mend_folds(SettledSurface& surface,
                                      std::vector<std::uint32_t>& suspects) {
  std::vector<std::uint32_t> changed;
  const auto forget_upright = [&] {
    std::erase_if(suspects, [&](std::uint32_t t) { return is_upright(surface, t); });
  };
  forget_upright();
  for (bool is_better = true; is_better && !suspects.empty();) {
    is_better = false;
    std::vector<std::uint32_t> others;
    for (const std::uint32_t t : suspects) {
      std::uint32_t other = kNone;
      if (is_upright(surface, t) || !mend(surface, t, other)) continue;
      is_better = true;
      changed.push_back(t);
      changed.push_back(other);
      others.push_back(other);
    }
    suspects.insert(suspects.end(), others.begin(), others.end());
    std::sort(suspects.begin(), suspects.end());
    suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
    forget_upright();
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

}  // namespace spoctree
