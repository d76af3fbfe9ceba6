// The triangles that a solid is made from while they are still being judged, and the words for
// places in them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/universe.hpp"

namespace spoctree {

using Corners = std::array<std::uint32_t, 3>;

/// More triangles than this are refused: three half-edges of each are numbered with 32 bits.
inline constexpr std::size_t kMaxTriangles = std::size_t{1} << 28;

/// Solids larger or smaller than this (in units of the file) are refused: their volume, in cubed
/// units, has to fit a double.
inline constexpr double kLargestExtent = 1e90;
inline constexpr double kSmallestExtent = 1e-90;

/// "(x, y, z)", "(x, y, z)–(x, y, z)" and so on, for the first three of `corners`.
std::string place_text(std::span<const glm::dvec3> points, std::span<const std::uint32_t> corners);

/// Triangles over points that are known in the file's coordinates (for messages) and, rounded, on
/// the grid (for everything else).
struct GridMesh {
  std::string_view name;  ///< of the file, for messages
  std::span<const glm::dvec3> points;
  Universe universe;
  std::vector<Vec3> vertices;  ///< `points` on the grid
  double box_diagonal = 0;     ///< of `vertices`, in universe units
  std::vector<Corners> triangles;

  /// Where the solid touches itself (touching.hpp): vertices behind those of `points` are copies of
  /// these points, and `touching` vertices must stay where they are.
  std::vector<std::uint32_t> copy_of;
  std::vector<std::uint32_t> touching;

  std::uint32_t point_of(std::uint32_t vertex) const {
    const std::size_t own = vertices.size() - copy_of.size();
    return vertex < own ? vertex : copy_of[vertex - own];
  }

  /// "(x, y, z)", "(x, y, z)–(x, y, z)" and so on: the points in the file's coordinates.
  std::string place(std::span<const std::uint32_t> corners) const {
    return place_text(points, corners);
  }
  std::string place(std::initializer_list<std::uint32_t> corners) const {
    return place(std::span(corners.begin(), corners.size()));
  }
  /// Throws BadInput("name: what").
  [[noreturn]] void fail(const std::string& what) const;
  /// The same, as UnsoundSurface.
  [[noreturn]] void fail_as_unsound(const std::string& what) const;
};

/// Chooses the universe cube, so that points may still move by `most_move` (in the file's units),
/// and rounds the points to its grid; the mesh has no triangles yet. Throws BadInput if there is no
/// point, if a coordinate is not finite or the extent is not between the limits above, and if
/// different points become one.
GridMesh place_on_grid(std::span<const glm::dvec3> points, std::string_view name,
                       double most_move = 0);

/// "1 border edge", "223 border edges".
std::string counted(std::size_t count, std::string_view thing);

}  // namespace spoctree
