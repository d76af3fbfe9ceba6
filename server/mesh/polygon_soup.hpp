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

#include "server/mesh/precision.hpp"

namespace spoctree {

/// Faces that are a line or a point, because they have one or two corners or their corners are
/// equal. They are left out while reading: such a face covers no area and its edges cancel in
/// pairs, so that the surface and its border are the same without it.
struct CollapsedFaces {
  std::size_t count = 0;
  std::size_t first = 0;  ///< number of the first of them among all faces of the file, from 0
};

/// Polygons over shared points, in the file's units, axes and order. Face i has the corners
/// corners[first_corner[i]] .. corners[first_corner[i + 1] - 1], each the number of a point.
struct PolygonSoup {
  std::vector<glm::dvec3> points;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> first_corner{0};  ///< face_count() + 1 entries
  CollapsedFaces collapsed;                    ///< not among the faces above
  /// What the file has that does not belong to its faces, or says wrongly of them: a line each, to
  /// be said to the user.
  std::vector<std::string> remarks;
  Precision precision;  ///< of the numbers in the file

  std::size_t face_count() const { return first_corner.size() - 1; }

  /// The corners of face `i`. REQUIRES i < face_count().
  std::span<const std::uint32_t> face(std::size_t i) const {
    return std::span(corners).subspan(first_corner[i], first_corner[i + 1] - first_corner[i]);
  }
};

/// A vertex number that stands more than once in `corners`, if there is one. O(n log n), and
/// without any allocation for the small faces that nearly all faces are.
std::optional<std::uint32_t> repeated_vertex(std::span<const std::uint32_t> corners);

/// A vertex number that stands more than once in a face that cannot be the boundary of one area, if
/// there is one. A face may come back to a vertex where an edge that it uses in both directions
/// bridges the way to a hole, and where the boundary touches itself; but then it has six corners or
/// more, uses some edge more often in one direction than in the other, and none more than once more
/// often. Whether it bounds one area is for triangulate to judge. n log n.
std::optional<std::uint32_t> wrongly_repeated_vertex(std::span<const std::uint32_t> corners);

/// Makes one face of the corners appended since the last face was closed. A corner equal to the one
/// before it is left out, and so is the face if fewer than three are left (soup.collapsed). Returns
/// an empty string, or what is wrong with the face ("has 0 corners, ..."); the soup is then fit
/// only to be thrown away. `index_base` is the number that the file format gives the first vertex.
std::string close_face(PolygonSoup& soup, std::uint32_t index_base = 0);

/// Leaves out every corner that is equal to the one before it, and every face of which fewer than
/// three are left then (soup.collapsed). False if there was nothing to leave out. Points stay, used
/// or not.
bool drop_collapsed_faces(PolygonSoup& soup);

}  // namespace spoctree
