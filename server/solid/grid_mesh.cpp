#include "server/solid/grid_mesh.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "common/base/errors.hpp"
#include "server/mesh/point_table.hpp"
#include "server/solid/first_found.hpp"
#include "server/solid/import_solid.hpp"

namespace spoctree {

namespace {

// A long polygon is recognised by its first corners.
constexpr std::size_t kMostCornersNamed = 3;

// What a file has in single precision is named with as many digits as that has.
std::string to_text(double value) {
  char buffer[32];
  value += 0.0;  // no "-0"
  const bool is_single = std::abs(value) <= std::numeric_limits<float>::max() &&
                         static_cast<double>(static_cast<float>(value)) == value;
  const auto end = is_single
                       ? std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(value))
                       : std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end.ptr};
}

}  // namespace

std::string place_text(std::span<const glm::dvec3> points, std::span<const std::uint32_t> corners) {
  std::string text;
  for (const std::uint32_t corner : corners.first(std::min(corners.size(), kMostCornersNamed))) {
    if (!text.empty()) text += "–";
    const glm::dvec3 p = points[corner];
    text.append("(").append(to_text(p.x)).append(", ").append(to_text(p.y));
    text.append(", ").append(to_text(p.z)).append(")");
  }
  return text;
}

void GridMesh::fail(const std::string& what) const {
  throw BadInput(std::string(name) + ": " + what);
}

void GridMesh::fail_as_unsound(const std::string& what) const {
  throw UnsoundSurface(std::string(name) + ": " + what);
}

std::string counted(std::size_t count, std::string_view thing) {
  return std::to_string(count) + " " + std::string(thing) + (count == 1 ? "" : "s");
}

GridMesh place_on_grid(std::span<const glm::dvec3> points, std::string_view name,
                       double most_move) {
  GridMesh mesh;
  mesh.name = name;
  mesh.points = points;
  if (points.empty()) mesh.fail("empty: no faces");
  Vec3 lower = points[0];
  Vec3 upper = points[0];
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vec3 p = points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      mesh.fail("a coordinate is not finite, at point " + mesh.place({i}));
    }
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  const Vec3 size = upper - lower;  // infinite at worst
  const double extent = std::max({size.x, size.y, size.z});
  if (!(extent >= kSmallestExtent && extent <= kLargestExtent)) {
    mesh.fail("its extent is " + to_text(extent) + ", not between " + to_text(kSmallestExtent) +
              " and " + to_text(kLargestExtent));
  }
  mesh.universe = universe_around(lower - most_move, upper + most_move);
  mesh.box_diagonal = glm::length(size / mesh.universe.scale());

  FirstFound<std::uint32_t> collisions;
  PointTable table(mesh.vertices);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vec3 y = mesh.universe.to_grid(points[i]);
    // A collision shifts the numbers of later points, but then they are not needed any more.
    if (table.find_or_add(y) + collisions.count() == i) continue;
    collisions.add(i);
  }
  if (collisions.count() > 0) {
    mesh.fail(counted(collisions.count(), "point") +
              " closer to another point than 2^-52 of the extent, " +
              collisions.places([&](std::uint32_t i) { return mesh.place({i}); }));
  }
  return mesh;
}

}  // namespace spoctree
