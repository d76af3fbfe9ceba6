#include "tools/model/round_solids.hpp"

#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>
#include <utility>

namespace spoctree::model {

namespace {

constexpr double kRadius = 50;
constexpr double kHeight = 100;

/// The point of the unit circle at the k-th of n equal steps. Computed within the first eighth and
/// reflected, so that the points mirror each other to the last bit and the axes are hit exactly.
glm::dvec2 point_on_circle(int k, int n) {
  const int quarter = 4 * k / n;
  int rest = 4 * k % n;  // of the quarter's n parts
  const bool beyond_half = 2 * rest > n;
  if (beyond_half) rest = n - rest;
  const double angle = std::numbers::pi / 2 * rest / n;
  // Two functions of the same angle would differ in the last bit at an eighth.
  glm::dvec2 point = 2 * rest == n ? glm::dvec2(std::numbers::sqrt2 / 2)
                                   : glm::dvec2(std::cos(angle), std::sin(angle));
  if (beyond_half) std::swap(point.x, point.y);
  for (int i = 0; i < quarter; ++i) point = {-point.y, point.x};
  return point;
}

void append_ring(PolygonMesh& mesh, int sides, double radius, double z) {
  for (int k = 0; k < sides; ++k) {
    const glm::dvec2 point = radius * point_on_circle(k, sides);
    mesh.points.emplace_back(point.x, point.y, z);
  }
}

/// The faces between two rings of points, the second one above the first.
void append_band(PolygonMesh& mesh, std::uint32_t low, std::uint32_t high, int sides) {
  const auto count = static_cast<std::uint32_t>(sides);
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t next = (k + 1) % count;
    mesh.faces.push_back({low + k, low + next, high + next, high + k});
  }
}

/// The triangles from a ring of points to a point above it, or below it.
void append_fan(PolygonMesh& mesh, std::uint32_t ring, int sides, std::uint32_t apex, bool above) {
  const auto count = static_cast<std::uint32_t>(sides);
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t a = ring + k;
    const std::uint32_t b = ring + (k + 1) % count;
    mesh.faces.push_back(above ? Loop{a, b, apex} : Loop{b, a, apex});
  }
}

void append_cap(PolygonMesh& mesh, std::uint32_t ring, int sides, bool faces_up) {
  const auto count = static_cast<std::uint32_t>(sides);
  Loop cap(count);
  for (std::uint32_t k = 0; k < count; ++k) cap[k] = ring + (faces_up ? k : count - 1 - k);
  mesh.faces.push_back(std::move(cap));
}

}  // namespace

PolygonMesh make_sphere(int bands) {
  const int sectors = 2 * bands;
  const auto stride = static_cast<std::uint32_t>(sectors);
  const auto rings = static_cast<std::uint32_t>(bands - 1);
  PolygonMesh mesh;
  for (int i = 1; i < bands; ++i) {
    const glm::dvec2 meridian = kRadius * point_on_circle(i, 2 * bands);  // from the north pole
    append_ring(mesh, sectors, meridian.y, -meridian.x);
  }
  const auto south = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back(0, 0, -kRadius);
  mesh.points.emplace_back(0, 0, kRadius);

  append_fan(mesh, 0, sectors, south, false);
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
    append_band(mesh, ring * stride, (ring + 1) * stride, sectors);
  append_fan(mesh, (rings - 1) * stride, sectors, south + 1, true);
  return mesh;
}

PolygonMesh make_wavy_sphere(int bands) {
  PolygonMesh mesh = make_sphere(bands);
  for (glm::dvec3& point : mesh.points) {
    const glm::dvec3 u = point / kRadius;
    point *= 1 + 0.05 * std::sin(9 * u.x) * std::sin(8 * u.y) * std::sin(7 * u.z);
  }
  std::vector<Loop> triangles;
  for (const Loop& face : mesh.faces) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      triangles.push_back({face[0], face[k], face[k + 1]});
  }
  mesh.faces = std::move(triangles);
  return mesh;
}

PolygonMesh make_cylinder(int sides) {
  const auto count = static_cast<std::uint32_t>(sides);
  PolygonMesh mesh;
  append_ring(mesh, sides, kRadius, 0);
  append_ring(mesh, sides, kRadius, kHeight);
  append_cap(mesh, 0, sides, false);
  append_band(mesh, 0, count, sides);
  append_cap(mesh, count, sides, true);
  return mesh;
}

PolygonMesh make_cone(int sides) {
  PolygonMesh mesh;
  append_ring(mesh, sides, kRadius, 0);
  mesh.points.emplace_back(0, 0, kHeight);
  append_cap(mesh, 0, sides, false);
  append_fan(mesh, 0, sides, static_cast<std::uint32_t>(sides), true);
  return mesh;
}

}  // namespace spoctree::model
