#include "tests/support/hand_solid.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <stdexcept>

#include "server/solid/facets.hpp"

namespace spoctree {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Universe unit_universe() { return {Vec3{0.0}, 0, 1.0}; }

Solid hand_solid(std::vector<Vec3> points, const Triangles& triangles, const Universe& universe) {
  Solid solid;
  solid.universe = universe;
  solid.vertices = std::move(points);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> triangle_of_edge;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_new =
          triangle_of_edge.insert({{triangles[t][i], triangles[t][(i + 1) % 3]}, t}).second;
      if (!is_new) throw std::invalid_argument("an edge stands twice");
    }
  }
  double six_volumes = 0;
  for (const auto& corners : triangles) {
    SolidTriangle triangle{{corners[0], corners[1], corners[2]}, {}, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto other = triangle_of_edge.find({corners[(i + 1) % 3], corners[i]});
      if (other == triangle_of_edge.end()) throw std::invalid_argument("an open edge");
      triangle.neighbour[i] = other->second;
    }
    six_volumes += glm::dot(solid.vertices[corners[0]],
                            glm::cross(solid.vertices[corners[1]], solid.vertices[corners[2]]));
    solid.triangles.push_back(triangle);
  }
  solid.volume = six_volumes / 6 * std::pow(universe.scale(), 3);
  group_into_facets(solid);
  return solid;
}

namespace {

/// Joins equal points while quads and triangles are added.
class Mesher {
 public:
  std::uint32_t point(Vec3 p) {
    const auto [at, is_new] =
        number_.insert({{p.x, p.y, p.z}, static_cast<std::uint32_t>(points.size())});
    if (is_new) points.push_back(p);
    return at->second;
  }
  void triangle(Vec3 a, Vec3 b, Vec3 c) { triangles.push_back({point(a), point(b), point(c)}); }
  void quad(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

  std::vector<Vec3> points;
  Triangles triangles;

 private:
  std::map<std::array<double, 3>, std::uint32_t> number_;
};

/// The side of the box across `axis`, counter-clockwise from outside.
void add_box_side(Mesher& mesher, Vec3 lower, Vec3 upper, int axis, bool is_upper) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  Vec3 a = lower;
  a[axis] = is_upper ? upper[axis] : lower[axis];
  Vec3 b = a;
  Vec3 c = a;
  Vec3 d = a;
  b[u] = c[u] = upper[u];
  c[v] = d[v] = upper[v];
  if (is_upper) {
    mesher.quad(a, b, c, d);
  } else {
    mesher.quad(a, d, c, b);
  }
}

Triangles triangles_of(const Solid& solid) {
  Triangles triangles;
  for (const SolidTriangle& t : solid.triangles) {
    triangles.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
  }
  return triangles;
}

}  // namespace

Solid box_solid(Vec3 lower, Vec3 upper) {
  Mesher mesher;
  for (int axis = 0; axis < 3; ++axis) {
    add_box_side(mesher, lower, upper, axis, false);
    add_box_side(mesher, lower, upper, axis, true);
  }
  return hand_solid(mesher.points, mesher.triangles);
}

Solid together(const Solid& a, const Solid& b) {
  std::vector<Vec3> points = a.vertices;
  points.insert(points.end(), b.vertices.begin(), b.vertices.end());
  Triangles triangles = triangles_of(a);
  const auto shift = static_cast<std::uint32_t>(a.vertices.size());
  for (auto t : triangles_of(b)) triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return hand_solid(points, triangles, a.universe);
}

Solid turned(const Solid& solid) {
  Triangles triangles = triangles_of(solid);
  for (auto& t : triangles) std::swap(t[1], t[2]);
  return hand_solid(solid.vertices, triangles, solid.universe);
}

Solid voxel_solid(const Voxels& voxels) {
  Mesher mesher;
  const int n = voxels.side();
  const double size = 2.0 / n;
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        if (!voxels(x, y, z)) continue;
        const Vec3 lower = Vec3(x, y, z) * size - 1.0;
        for (int axis = 0; axis < 3; ++axis) {
          for (const int step : {-1, 1}) {
            int next[3] = {x, y, z};
            next[axis] += step;
            if (voxels(next[0], next[1], next[2])) continue;
            add_box_side(mesher, lower, lower + size, axis, step > 0);
          }
        }
      }
    }
  }
  return hand_solid(mesher.points, mesher.triangles);
}

namespace {

/// Whether those of the eight cells around a corner that have `state` hang together by faces, and
/// of the four around each of its edges.
bool hangs_together(unsigned full) {
  for (const bool state : {false, true}) {
    const unsigned set = state ? full : ~full & 0xffu;
    if (set == 0) continue;
    unsigned reached = set & (~set + 1);
    for (int round = 0; round < 8; ++round) {
      for (unsigned cell = 0; cell < 8; ++cell) {
        if (!((reached >> cell) & 1)) continue;
        for (const unsigned axis : {1u, 2u, 4u}) reached |= (1u << (cell ^ axis)) & set;
      }
    }
    if (reached != set) return false;
  }
  // Two full cells across an edge, the other two empty: not a manifold.
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned u = 1u << ((axis + 1) % 3);
    const unsigned v = 1u << ((axis + 2) % 3);
    for (const unsigned base : {0u, 1u << axis}) {
      const auto at = [&](unsigned cell) { return (full >> cell) & 1; };
      if (at(base) == at(base | u | v) && at(base | u) == at(base | v) && at(base) != at(base | u))
        return false;
    }
  }
  return true;
}

bool is_manifold_at(const Voxels& voxels, int x, int y, int z) {
  unsigned full = 0;
  for (int cell = 0; cell < 8; ++cell) {
    if (voxels(x - 1 + (cell & 1), y - 1 + ((cell >> 1) & 1), z - 1 + ((cell >> 2) & 1)))
      full |= 1u << cell;
  }
  return hangs_together(full);
}

}  // namespace

bool is_manifold(const Voxels& voxels) {
  for (int z = 0; z <= voxels.side(); ++z) {
    for (int y = 0; y <= voxels.side(); ++y) {
      for (int x = 0; x <= voxels.side(); ++x) {
        if (!is_manifold_at(voxels, x, y, z)) return false;
      }
    }
  }
  return true;
}

Voxels random_voxels(int depth, Random& random) {
  const int n = 1 << depth;
  const auto full = std::make_shared<std::vector<char>>(static_cast<std::size_t>(n * n * n), 0);
  const auto index = [n](int x, int y, int z) {
    return static_cast<std::size_t>((z * n + y) * n + x);
  };
  Voxels voxels{depth, [full, index](int x, int y, int z) { return (*full)[index(x, y, z)] != 0; }};
  const auto side = static_cast<std::uint32_t>(n);
  (*full)[index(n / 2, n / 2, n / 2)] = 1;
  for (int attempt = 0; attempt < 12 * n * n * n; ++attempt) {
    const int x = static_cast<int>(random.below(side));
    const int y = static_cast<int>(random.below(side));
    const int z = static_cast<int>(random.below(side));
    char& cell = (*full)[index(x, y, z)];
    cell = static_cast<char>(!cell);
    bool is_fine = true;
    for (int corner = 0; corner < 8; ++corner) {
      is_fine &= is_manifold_at(voxels, x + (corner & 1), y + ((corner >> 1) & 1),
                                z + ((corner >> 2) & 1));
    }
    if (!is_fine) cell = static_cast<char>(!cell);
  }
  bool any = false;
  for (const char cell : *full) any |= cell != 0;
  if (!any) (*full)[0] = 1;
  return voxels;
}

std::optional<bool> HeightField::is_inside(Vec3 point) const {
  const Vec3 local = (point - corner) / step;
  if (local.x < 0 || local.y < 0 || local.x > cells || local.y > cells) return false;
  if (local.x == 0 || local.y == 0 || local.x == cells || local.y == cells) return std::nullopt;
  const int x = std::min(static_cast<int>(local.x), cells - 1);
  const int y = std::min(static_cast<int>(local.y), cells - 1);
  const double u = local.x - x;
  const double v = local.y - y;
  // The diagonal runs from (x, y) to (x + 1, y + 1).
  const double a = height(x, y);
  const double c = height(x + 1, y + 1);
  const double top = u >= v ? a + (height(x + 1, y) - a) * u + (c - height(x + 1, y)) * v
                            : a + (height(x, y + 1) - a) * v + (c - height(x, y + 1)) * u;
  if (point.z == top || point.z == corner.z) return std::nullopt;
  return point.z > corner.z && point.z < top;
}

double HeightField::volume() const {
  double sum = 0;
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      const double ends = height(x, y) + height(x + 1, y + 1) - 2 * corner.z;
      sum += (ends + height(x + 1, y) - corner.z) / 6 + (ends + height(x, y + 1) - corner.z) / 6;
    }
  }
  return sum * step * step;
}

HeightField random_height_field(int cells, Vec3 corner, double step, double lowest, double unit,
                                std::uint32_t range, Random& random) {
  HeightField field{cells, corner, step, {}};
  for (int i = 0; i < (cells + 1) * (cells + 1); ++i) {
    field.heights.push_back(lowest + unit * random.below(range));
  }
  return field;
}

Solid height_field_solid(const HeightField& field) {
  Mesher mesher;
  const auto place = [&](int x, int y, bool top) {
    return Vec3(field.corner.x + x * field.step, field.corner.y + y * field.step,
                top ? field.height(x, y) : field.corner.z);
  };
  const int n = field.cells;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      mesher.quad(place(x, y, true), place(x + 1, y, true), place(x + 1, y + 1, true),
                  place(x, y + 1, true));
      mesher.quad(place(x, y, false), place(x, y + 1, false), place(x + 1, y + 1, false),
                  place(x + 1, y, false));
    }
  }
  const auto wall = [&](int x0, int y0, int x1, int y1) {
    mesher.quad(place(x0, y0, false), place(x1, y1, false), place(x1, y1, true),
                place(x0, y0, true));
  };
  for (int i = 0; i < n; ++i) {
    wall(i, 0, i + 1, 0);
    wall(n, i, n, i + 1);
    wall(i + 1, n, i, n);
    wall(0, i + 1, 0, i);
  }
  return hand_solid(mesher.points, mesher.triangles);
}

}  // namespace spoctree
