// Some faces of a soup, in their order.
#pragma once

#include <algorithm>
#include <vector>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Drops the faces for which is_kept is false. Points stay, used or not. Linear.
inline void keep_faces(PolygonSoup& soup, const std::vector<bool>& is_kept) {
  std::size_t end = 0;
  std::size_t faces = 0;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const std::size_t begin = soup.first_corner[f];
    const std::size_t size = soup.first_corner[f + 1] - begin;
    if (!is_kept[f]) continue;
    std::copy_n(soup.corners.begin() + static_cast<std::ptrdiff_t>(begin), size,
                soup.corners.begin() + static_cast<std::ptrdiff_t>(end));
    soup.first_corner[faces++] = static_cast<std::uint32_t>(end);
    end += size;
  }
  soup.first_corner.resize(faces + 1);
  soup.first_corner[faces] = static_cast<std::uint32_t>(end);
  soup.corners.resize(end);
}

}  // namespace spoctree
