// What the tests of the mesh readers share: errors as text, soups as plain lists, files as bytes.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/base/errors.hpp"
#include "server/mesh/polygon_soup.hpp"
#include "server/mesh/stored_number.hpp"

namespace spoctree::mesh_test {

/// The text of the BadInput that `action` throws; "no error" if it throws none.
template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "no error";
}

inline std::vector<std::vector<std::uint32_t>> faces_of(const PolygonSoup& soup) {
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t i = 0; i < soup.face_count(); ++i) {
    const auto face = soup.face(i);
    faces.emplace_back(face.begin(), face.end());
  }
  return faces;
}

/// What every reader promises of every soup that it returns; empty if it is kept.
inline std::string broken_promise(const PolygonSoup& soup) {
  for (const glm::dvec3& p : soup.points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return "not finite";
  }
  if (soup.first_corner.empty() || soup.first_corner.front() != 0) return "first_corner";
  if (soup.first_corner.back() != soup.corners.size()) return "open face";
  if (soup.face_count() == 0) return "no face";
  for (const auto& face : faces_of(soup)) {
    if (face.size() < 3) return "small face";
    const std::size_t different = std::set<std::uint32_t>(face.begin(), face.end()).size();
    if (different < 3) return "collapsed face";
    if (different != face.size() && face.size() < 6) return "repeats";
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t from = face[i];
      const std::uint32_t to = face[(i + 1) % face.size()];
      if (from == to) return "equal neighbours";
      sides[std::minmax(from, to)] += from < to ? 1 : -1;
    }
    for (const auto& [ends, sum] : sides) {
      if (sum < -1 || sum > 1) return "an edge more than once";
    }
    for (const std::uint32_t corner : face) {
      if (corner >= soup.points.size()) return "corner out of range";
    }
  }
  return "";
}

/// Appends a number as `T` in the given byte order.
template <class T>
void append(std::string& bytes, T value, ByteOrder order = ByteOrder::LittleEndian) {
  std::uint64_t bits = 0;
  if constexpr (std::is_same_v<T, float>) {
    bits = std::bit_cast<std::uint32_t>(value);
  } else if constexpr (std::is_same_v<T, double>) {
    bits = std::bit_cast<std::uint64_t>(value);
  } else {
    bits = static_cast<std::uint64_t>(value);
  }
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const std::size_t place = order == ByteOrder::LittleEndian ? i : sizeof(T) - 1 - i;
    bytes += static_cast<char>((bits >> (8 * place)) & 0xff);
  }
}

// The tetrahedron with corners at the origin and the three unit points, seen from outside.
inline const std::vector<glm::dvec3> kTetrahedronPoints = {
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline const std::vector<std::vector<std::uint32_t>> kTetrahedronFaces = {
    {0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

inline std::string binary_stl(const std::string& header,
                              const std::vector<std::vector<glm::dvec3>>& facets) {
  std::string bytes = header;
  bytes.resize(80, '\0');
  append(bytes, static_cast<std::uint32_t>(facets.size()));
  for (const auto& facet : facets) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0F);
    for (const glm::dvec3& corner : facet) {
      for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(corner[axis]));
    }
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

inline std::string tetrahedron_binary_stl(const std::string& header = "") {
  std::vector<std::vector<glm::dvec3>> facets;
  for (const auto& face : kTetrahedronFaces) {
    facets.emplace_back();
    for (const std::uint32_t corner : face) facets.back().push_back(kTetrahedronPoints[corner]);
  }
  return binary_stl(header, facets);
}

inline const std::string kTetrahedronOff =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

inline const std::string kTetrahedronObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

inline const std::string kTetrahedronTextStl =
    "solid tetrahedron\n"
    "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
    "facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "endsolid tetrahedron\n";

inline const std::string kTetrahedronTextPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

inline std::string tetrahedron_binary_ply(ByteOrder order) {
  std::string bytes = "ply\nformat binary_";
  bytes += order == ByteOrder::LittleEndian ? "little" : "big";
  bytes +=
      "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  for (const glm::dvec3& point : kTetrahedronPoints) {
    for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(point[axis]), order);
  }
  for (const auto& face : kTetrahedronFaces) {
    append(bytes, std::uint8_t{3});
    for (const std::uint32_t corner : face) append(bytes, static_cast<std::int32_t>(corner), order);
  }
  return bytes;
}

}  // namespace spoctree::mesh_test
