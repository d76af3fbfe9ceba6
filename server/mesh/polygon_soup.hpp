// What a mesh file says, and no more: points, and faces as lists of point numbers. Whether the
// faces bound a solid is judged elsewhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spoctree {

/// Polygons over shared points, in the file's units, axes and order. Face i has the corners
/// corners[first_corner[i]] .. corners[first_corner[i + 1] - 1], each the number of a point.
struct PolygonSoup {
  std::vector<glm::dvec3> points;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> first_corner{0};  ///< face_count() + 1 entries

  std::size_t face_count() const { return first_corner.size() - 1; }

  /// The corners of face `i`. REQUIRES i < face_count().
  std::span<const std::uint32_t> face(std::size_t i) const {
    return std::span(corners).subspan(first_corner[i], first_corner[i + 1] - first_corner[i]);
  }
};

/// A vertex number that stands more than once in `corners`, if there is one. O(n log n), and
/// without any allocation for the small faces that nearly all faces are.
std::optional<std::uint32_t> repeated_vertex(std::span<const std::uint32_t> corners);

/// Makes one face of the corners appended since the last face was closed. Returns an empty string,
/// or what is wrong with the face ("has 2 corners, ..."); the soup is then fit only to be thrown
/// away. `index_base` is the number that the file format gives the first vertex.
std::string close_face(PolygonSoup& soup, std::uint32_t index_base = 0);

}  // namespace spoctree
