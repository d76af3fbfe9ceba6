#include "server/mesh/polygon_soup.hpp"

#include <algorithm>

#include "server/mesh/limits.hpp"

namespace spoctree {

std::optional<std::uint32_t> repeated_vertex(std::span<const std::uint32_t> corners) {
  constexpr std::size_t kCompareAllPairs = 8;
  if (corners.size() <= kCompareAllPairs) {
    for (std::size_t i = 1; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (corners[i] == corners[j]) return corners[i];
      }
    }
    return std::nullopt;
  }
  std::vector<std::uint32_t> sorted(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
  if (twin == sorted.end()) return std::nullopt;
  return *twin;
}

std::string close_face(PolygonSoup& soup, std::uint32_t index_base) {
  const auto face = std::span(soup.corners).subspan(soup.first_corner.back());
  if (face.size() < 3) {
    return "has " + std::to_string(face.size()) + (face.size() == 1 ? " corner" : " corners") +
           ", a face needs 3 or more";
  }
  if (const auto vertex = repeated_vertex(face)) {
    return "uses vertex " + std::to_string(std::uint64_t{*vertex} + index_base) + " more than once";
  }
  if (soup.corners.size() > mesh_limits::kMaxCorners) {
    return "takes the file over the limit of " + std::to_string(mesh_limits::kMaxCorners) +
           " face corners";
  }
  if (soup.face_count() >= mesh_limits::kMaxFaces) {
    return "takes the file over the limit of " + std::to_string(mesh_limits::kMaxFaces) + " faces";
  }
  soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  return {};
}

}  // namespace spoctree
