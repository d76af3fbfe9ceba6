// Holes in a soup into patches of triangles.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/first_found.hpp"

namespace spoctree {

/// A closed line of border edges, each with one face only.
struct Hole {
  std::array<std::uint32_t, 2> first_edge{};  ///< points: the smallest of its numbers, and the next
  std::size_t edges = 0;
  double size = 0;  ///< diagonal of its bounding box, in units of the file
  bool is_flat = false;
  auto operator<=>(const Hole& other) const { return first_edge <=> other.first_edge; }
  bool operator==(const Hole& other) const { return first_edge == other.first_edge; }
};

struct FilledHoles {
  double whole = 0;  ///< diagonal of the bounding box of all
  FirstFound<Hole> filled;
  Hole largest;                 ///< of those filled, by size
  std::size_t faces = 0;        ///< put in
  FirstFound<Hole> too_long;    ///< more edges than kMostHoleEdges allows
  FirstFound<Hole> too_large;   ///< not flat, and larger than kLargestHole of the whole
  FirstFound<Hole> unfillable;  ///< no patch was found, or only one that meets itself or other
                                ///< faces in an edge that is there already
  FirstFound<Hole> of_scraps;   ///< around surfaces that are hardly more than their border
  std::vector<bool> is_scrap;   ///< of each face: whether it belongs to one of those
};

/// Fills every hole within the limits of repair.hpp. Each is a simple closed line: holes that touch
/// in a point are taken apart there. A patch has the hole's points only. Flat holes of many edges
/// get one polygon; for others, among the patches that CGAL's triangulate_hole_polyline considers
/// (those in the Delaunay triangulation of the points, if any will do), the one with the smallest
/// angles to its surroundings, then the smallest area. n log n, and quadratic in kMostHoleEdges.
/// Surfaces with edges along which faces do not run as often up as down are passed over: there
/// holes cannot be told from seams. So are scraps, which filling would make slivers of solids: what
/// needs as many triangles as it has, is flat but for kFlatPiece, or is small beside the rest and
/// flat but for kFlatScrap.
/// REQUIRES: faces agree about the outside (agree_on_outside).
FilledHoles fill_holes(PolygonSoup& soup);

}  // namespace spoctree
