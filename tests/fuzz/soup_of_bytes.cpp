#include "tests/fuzz/soup_of_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "server/mesh/merge_equal_points.hpp"

namespace spoctree {

namespace {

constexpr std::size_t kMostPoints = 64;

// Takes the faces over that still have every point once.
void drop_pinched_faces(PolygonSoup& soup) {
  PolygonSoup kept;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    if (repeated_vertex(face)) continue;
    kept.corners.insert(kept.corners.end(), face.begin(), face.end());
    kept.first_corner.push_back(static_cast<std::uint32_t>(kept.corners.size()));
  }
  soup.corners = kept.corners;
  soup.first_corner = kept.first_corner;
}

}  // namespace

PolygonSoup soup_of_bytes(std::string_view bytes) {
  const auto next = [&bytes]() -> int {
    if (bytes.empty()) return 0;
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    return byte;
  };
  PolygonSoup soup;
  const std::size_t points = 1 + static_cast<std::size_t>(next()) % kMostPoints;
  const int kinds = next();
  const int spread = kinds % 4;
  if (kinds / 4 % 4 == 1) soup.precision.unit = 1;
  if (kinds / 4 % 4 == 2) soup.precision.decimal_digits = 4;
  if (kinds / 4 % 4 == 3) soup.precision.unit = 1e-7;
  for (std::size_t i = 0; i < points; ++i) {
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      const int value = next();
      point[axis] = value < 128 ? value : value - 256;
      if (spread == 1) point[axis] += 1e-8 * (value * 7 % 11);
      if (spread == 2) point[axis] = std::ldexp(point[axis], value * 5 % 60 - 20);
      if (spread == 3) point[axis] = std::ldexp(point[axis], value * 37 % 1200 - 600);
    }
    soup.points.push_back(point);
  }
  while (!bytes.empty()) {
    const int corners = 3 + next() % 4;
    for (int i = 0; i < corners; ++i) {
      soup.corners.push_back(static_cast<std::uint32_t>(next()) %
                             static_cast<std::uint32_t>(points));
    }
    if (!close_face(soup).empty()) soup.corners.resize(soup.first_corner.back());
  }
  merge_equal_points(soup);
  drop_pinched_faces(soup);
  merge_equal_points(soup);
  return soup;
}

std::string bytes_of_soup(const PolygonSoup& soup) {
  double largest = 0;
  for (const glm::dvec3& p : soup.points) {
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(p[axis]));
  }
  std::string bytes;
  bytes += static_cast<char>(soup.points.size() - 1);
  bytes += '\0';
  for (const glm::dvec3& p : soup.points) {
    for (int axis = 0; axis < 3; ++axis) {
      bytes += static_cast<char>(std::lround(127 * p[axis] / largest));
    }
  }
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    bytes += static_cast<char>(face.size() - 3);
    for (const std::uint32_t corner : face) bytes += static_cast<char>(corner);
  }
  return bytes;
}

}  // namespace spoctree
