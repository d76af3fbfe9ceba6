#include "server/solid/soup_edges.hpp"

#include <algorithm>

namespace spoctree {

std::vector<SoupSide> sides_by_edge(const PolygonSoup& soup) {
  std::vector<SoupSide> sides;
  sides.reserve(soup.corners.size());
  for (std::uint32_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    for (std::uint32_t i = 0; i < face.size(); ++i) {
      const auto [low, high] = std::minmax(face[i], face[i + 1 == face.size() ? 0 : i + 1]);
      sides.push_back({low, high, f, soup.first_corner[f] + i});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace spoctree
