// What bounds nothing, out of a soup: scraps that lie about, and flaps that hang on a solid.
#pragma once

#include <vector>

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/first_found.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

/// A piece of surface that may be told from the faces around it by its first one.
struct DroppedPiece {
  FacePlace first;
  std::size_t faces = 0;
  auto operator<=>(const DroppedPiece& other) const { return first <=> other.first; }
  bool operator==(const DroppedPiece& other) const { return first == other.first; }
};

struct DroppedPieces {
  FirstFound<DroppedPiece> pieces;
  std::size_t faces = 0;
};

/// Open surfaces up to this, as a part of the area of all that is closed, are debris whatever they
/// look like; scraps up to as much area as that; flat ones, such as a ground, of any size.
inline constexpr double kLargestDebris = 0.05;
inline constexpr double kFlatPiece = 0.99;

/// Drops flaps: pieces of surface (connected across edges with two faces) with a border that hang
/// on edges with three or more faces, each of which keeps two or more. First goes what has most
/// border for its area. Only where the surface is then closed along all these edges: what was a
/// flap of another goes in the next of kMostFlapRounds. n log n a round.
DroppedPieces drop_flaps(PolygonSoup& soup);

inline constexpr int kMostFlapRounds = 16;

/// Drops surfaces (connected across any edges) that bound nothing, if something else is closed:
/// open ones within the limits above, and closed ones that lie in one plane, exactly.
/// `is_scrap` says of faces that they belong to a surface that is hardly more than its border
/// (FilledHoles); those without an entry do not. n log n.
DroppedPieces drop_debris(PolygonSoup& soup, const std::vector<bool>& is_scrap);

}  // namespace spoctree
