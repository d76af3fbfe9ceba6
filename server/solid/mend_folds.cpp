#include "server/solid/mend_folds.hpp"

#include <algorithm>
#include <cstdlib>

namespace spoctree {

namespace {

// Edges are not turned at vertices with more triangles: finding out what they are joined to already
// would take too long.
constexpr int kMostTriangles = 1000;

// Higher triangles, in universe units, are no needles that rounding might turn over.
constexpr double kThick = 0x1p-44;

constexpr int kMostPasses = 1000;

double squared_length(const SettledSurface& surface, std::uint32_t p, std::uint32_t q) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = static_cast<double>(surface.points[q][i] - surface.points[p][i]) * 0x1p-52;
    sum += d * d;
  }
  return sum;
}

enum Shape { TurnedOver = 0, Thin = 1, Thick = 2 };

// Of a triangle in a plane with this normal; whether it is turned over is exact.
Shape shape_of(const SettledSurface& surface, const GridPoint& normal, const Corners& t) {
  const auto axis = static_cast<std::size_t>(
      std::max_element(normal.begin(), normal.end(),
                       [](std::int64_t p, std::int64_t q) { return std::abs(p) < std::abs(q); }) -
      normal.begin());
  Int128 area = area_vector(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]])[axis];
  if (normal[axis] < 0) area = -area;
  if (area <= 0) return TurnedOver;
  const double longest =
      std::sqrt(std::max({squared_length(surface, t[0], t[1]), squared_length(surface, t[1], t[2]),
                          squared_length(surface, t[2], t[0])}));
  return static_cast<double>(area) * 0x1p-104 > kThick * longest ? Thick : Thin;
}

Shape shape_of(const SettledSurface& surface, std::uint32_t triangle) {
  const FlatGroup& group = surface.groups->groups[surface.groups->of_triangle[triangle]];
  return shape_of(surface, group.plane.normal, surface.triangles[triangle]);
}

// What turning edges makes larger: thick triangles count first, then those not turned over.
int merit(Shape p, Shape q) { return 3 * ((p == Thick) + (q == Thick)) + (p > 0) + (q > 0); }

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

// Turns edge `i` of triangle `t` if that has merit; `other` is the second triangle then.
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
  if (merit(shape_of(surface, normal, first), shape_of(surface, normal, second)) <=
      merit(shape_of(surface, normal, a), shape_of(surface, normal, b))) {
    return false;
  }
  if (is_joined(surface, t, r, s)) return false;

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

std::vector<std::uint32_t> mend_folds(SettledSurface& surface,
                                      std::vector<std::uint32_t>& suspects) {
  std::vector<std::uint32_t> changed;
  const auto forget = [&](Shape least) {
    std::erase_if(suspects, [&](std::uint32_t t) { return shape_of(surface, t) >= least; });
  };
  forget(Thick);
  bool is_better = true;
  for (int pass = 0; is_better && pass < kMostPasses; ++pass) {
    is_better = false;
    std::vector<std::uint32_t> others;
    // Backwards every other time: needles are mended one after the other, from one end.
    for (const std::uint32_t t : suspects) {
      std::uint32_t other = kNone;
      if (shape_of(surface, t) == Thick || !mend(surface, t, other)) continue;
      is_better = true;
      changed.push_back(t);
      changed.push_back(other);
      others.push_back(other);
    }
    if (others.empty()) break;
    suspects.insert(suspects.end(), others.begin(), others.end());
    std::sort(suspects.begin(), suspects.end());
    suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
    forget(Thick);
    if (pass % 2 == 0) std::reverse(suspects.begin(), suspects.end());
  }
  forget(Thin);
  std::sort(suspects.begin(), suspects.end());
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

}  // namespace spoctree
