#include "server/solid/flat_surface.hpp"

#include "common/base/parallel.hpp"

namespace spoctree {

namespace {

// Any mixture does: equal hashes are told apart by the planes themselves.
std::uint64_t hash_of(const GridPlane& plane) {
  std::uint64_t hash = static_cast<std::uint64_t>(plane.offset);
  for (const std::int64_t component : plane.normal) {
    hash ^= static_cast<std::uint64_t>(component) + (hash << 6) + (hash >> 2);
    hash *= 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return hash;
}

struct HashedPlane {
  std::uint64_t hash;
  std::uint32_t index;
};

double area_of(const Corners& t, std::span<const GridPoint> points) {
  const AreaVector area = area_vector(points[t[0]], points[t[1]], points[t[2]]);
  const auto x = static_cast<double>(area[0]);
  const auto y = static_cast<double>(area[1]);
  const auto z = static_cast<double>(area[2]);
  return 0.5 * 0x1p-104 * std::sqrt(x * x + y * y + z * z);
}

}  // namespace

GridPlane plane_of(const Corners& t, std::span<const GridPoint> points) {
  return nearest_plane(area_vector(points[t[0]], points[t[1]], points[t[2]]), points[t[0]]);
}

std::vector<GridPlane> planes_of(std::span<const Corners> triangles,
                                 std::span<const GridPoint> points) {
  std::vector<GridPlane> planes(triangles.size());
  parallel_for(triangles.size(),
               [&](std::size_t i) { planes[i] = plane_of(triangles[i], points); });
  return planes;
}

NumberedPlanes number_planes(std::span<const GridPlane> planes) {
  std::vector<HashedPlane> hashed(planes.size());
  for (std::uint32_t i = 0; i < planes.size(); ++i) hashed[i] = {hash_of(planes[i]), i};
  parallel_sort(hashed, [&](const HashedPlane& p, const HashedPlane& q) {
    if (p.hash != q.hash) return p.hash < q.hash;
    const auto order = planes[p.index] <=> planes[q.index];
    return order != 0 ? order < 0 : p.index < q.index;
  });
  NumberedPlanes numbered;
  numbered.number_of.resize(planes.size());
  // First the first of its equals for everyone, then numbers in the order of these.
  for (std::size_t begin = 0; begin < hashed.size();) {
    const std::uint32_t first = hashed[begin].index;
    std::size_t i = begin;
    for (; i < hashed.size() && hashed[i].hash == hashed[begin].hash &&
           planes[hashed[i].index] == planes[first];
         ++i) {
      numbered.number_of[hashed[i].index] = first;
    }
    begin = i;
  }
  for (std::uint32_t i = 0; i < planes.size(); ++i) {
    const std::uint32_t first = numbered.number_of[i];
    if (first == i) {
      numbered.number_of[i] = static_cast<std::uint32_t>(numbered.first.size());
      numbered.first.push_back(i);
    } else {
      numbered.number_of[i] = numbered.number_of[first];  // `first` has its number already
    }
  }
  return numbered;
}

FlatSurface make_flat_surface(std::span<const Vec3> vertices, std::span<const Corners> triangles,
                              std::span<const Corners> neighbours) {
  FlatSurface surface;
  surface.triangles = triangles;
  surface.neighbours = neighbours;
  surface.points.reserve(vertices.size());
  for (const Vec3 v : vertices) surface.points.push_back(to_grid_integers(v));
  surface.planes = planes_of(triangles, surface.points);
  NumberedPlanes numbered = number_planes(surface.planes);
  surface.plane_numbers = std::move(numbered.number_of);
  surface.distinct_planes = numbered.first.size();
  surface.areas.reserve(triangles.size());
  for (const Corners& t : triangles) surface.areas.push_back(area_of(t, surface.points));
  surface.triangle_at.assign(vertices.size(), kNone);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (const std::uint32_t v : triangles[t]) surface.triangle_at[v] = t;
  }
  return surface;
}

}  // namespace spoctree
