#include "server/mesh/closed_surface.hpp"

#include <algorithm>
#include <vector>

#include "server/mesh/merge_equal_points.hpp"

namespace spoctree {

bool is_closed_surface(PolygonSoup soup) {
  merge_equal_points(soup);
  if (soup.face_count() == 0) return false;
  std::vector<std::uint64_t> edges;
  edges.reserve(soup.corners.size());
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [low, high] = std::minmax(face[i], face[i + 1 < face.size() ? i + 1 : 0]);
      edges.push_back(std::uint64_t{low} << 32 | high);
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    if (i + 1 == edges.size() || edges[i] != edges[i + 1]) return false;
  }
  return true;
}

}  // namespace spoctree
