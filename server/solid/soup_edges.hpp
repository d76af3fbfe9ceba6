// The edges of a polygon soup: which faces run along each, and in which direction.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// A face, by its number in the soup of the moment, and its first corners, whose numbers stay:
/// where to look for it.
struct FacePlace {
  std::uint32_t face;
  std::array<std::uint32_t, 3> corners;
  auto operator<=>(const FacePlace& other) const { return face <=> other.face; }
  bool operator==(const FacePlace& other) const { return face == other.face; }
};

inline FacePlace place_of_face(const PolygonSoup& soup, std::uint32_t face) {
  const auto corners = soup.face(face);
  return {face, {corners[0], corners[1], corners[2]}};
}

/// A face's side, filed under the edge's two points.
struct SoupSide {
  std::uint32_t low;   ///< the smaller of the two points
  std::uint32_t high;  ///< the larger
  std::uint32_t face;
  std::uint32_t corner;  ///< where the side begins, as a place in PolygonSoup::corners
  auto operator<=>(const SoupSide&) const = default;
};

/// All sides of all faces, sorted: those of one edge stand together, in the order of their faces.
/// n log n.
std::vector<SoupSide> sides_by_edge(const PolygonSoup& soup);

/// Whether the face runs from the edge's smaller point to its larger one.
inline bool runs_up(const PolygonSoup& soup, const SoupSide& side) {
  return soup.corners[side.corner] == side.low;
}

/// Calls visit(sides of one edge) for each edge. REQUIRES: sides as from sides_by_edge.
template <class Visit>
void for_each_edge(std::span<const SoupSide> sides, const Visit& visit) {
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
      ++end;
    visit(sides.subspan(i, end - i));
    i = end;
  }
}

}  // namespace spoctree
