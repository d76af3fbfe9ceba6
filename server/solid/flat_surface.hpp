// What merging knows of a surface: its triangles in exact numbers.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "server/solid/grid_mesh.hpp"
#include "server/solid/grid_plane.hpp"

namespace spoctree {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A judged surface, before any corner has moved.
struct FlatSurface {
  std::span<const Corners> triangles;
  std::span<const Corners> neighbours;  ///< the triangle across edge i, from corner i to i + 1
  std::vector<GridPoint> points;
  std::vector<GridPlane> planes;             ///< of the triangles
  std::vector<std::uint32_t> plane_numbers;  ///< equal for triangles with equal planes
  std::size_t distinct_planes = 0;
  std::vector<double> areas;               ///< of the triangles, universe units
  std::vector<std::uint32_t> triangle_at;  ///< one of the triangles around each vertex
};

/// Linear, but for sorting. REQUIRES: vertices on the grid, no degenerate triangle.
FlatSurface make_flat_surface(std::span<const Vec3> vertices, std::span<const Corners> triangles,
                              std::span<const Corners> neighbours);

/// The rounded plane of a triangle. REQUIRES: not degenerate.
GridPlane plane_of(const Corners& triangle, std::span<const GridPoint> points);

/// The rounded planes of all triangles.
std::vector<GridPlane> planes_of(std::span<const Corners> triangles,
                                 std::span<const GridPoint> points);

/// Equal planes have equal numbers, in the order in which they first occur.
struct NumberedPlanes {
  std::vector<std::uint32_t> number_of;
  std::vector<std::uint32_t> first;  ///< for each number, where it occurs first
};

/// n log n.
NumberedPlanes number_planes(std::span<const GridPlane> planes);

/// Calls visit(t) for every triangle around `vertex`, a corner of `triangle`, which comes first, in
/// order. REQUIRES: the triangles around every vertex form one fan.
template <class Visit>
void visit_fan(std::span<const Corners> triangles, std::span<const Corners> neighbours,
               std::uint32_t triangle, std::uint32_t vertex, Visit visit) {
  std::uint32_t t = triangle;
  do {
    visit(t);
    const Corners& corners = triangles[t];
    t = neighbours[t][corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2];
  } while (t != triangle);
}

}  // namespace spoctree
