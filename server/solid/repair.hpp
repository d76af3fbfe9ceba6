// A soup whose faces do not quite bound a solid into one that may, saying what was changed.
#pragma once

#include <string>
#include <vector>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Uneven holes with more edges than this are left open, since filling takes time and memory with
/// the square of them; and those that come after so many that the squares add up to its square.
inline constexpr std::size_t kMostHoleEdges = 1000;

/// Flat holes with more edges than this are closed by one polygon.
inline constexpr std::size_t kMostFlatHoleEdges = 50;

/// Holes that are not flat and have more than kFewHoleEdges edges are left open if they are larger
/// than this, as a fraction of the bounding box's diagonal: beyond it, the shape that is missing
/// would be guessed. With few edges, at most one diagonal is.
inline constexpr std::size_t kFewHoleEdges = 4;
inline constexpr double kLargestHole = 0.25;

/// A hole counts as flat if its edges stay so close to one plane, as a fraction of its own size.
inline constexpr double kFlatHole = 0.01;

/// A surface up to kLargestDebris of all is not closed into a solid of its own if it is as flat as
/// this (what is seen of it from the best side, as a part of its area).
inline constexpr double kFlatScrap = 0.8;

struct Repair {
  PolygonSoup soup;
  /// One line for each kind of change: how often, and the first places. Empty: nothing was changed.
  std::vector<std::string> changes;
  /// What was seen, but not repaired.
  std::vector<std::string> refusals;
};

/// In this order, each step only where the mesh has what it mends:
/// - points that the grid cannot tell apart become one (settle_on_grid; import_solid does so, too);
/// - faces that stand twice lose their copies; where both sides of such a face are walled off by
///   others, the face itself too (two parts that share a wall become one);
/// - triangles whose corners are on one line (exactly) vanish, and the face beyond their longest
///   side gets their middle corner: no point of the surface is lost or moved;
/// - open edges whose ends nearly match become one, corners within open edges are put into them
///   (mend_borders): these are the only points that move, by less than kWidestCrack of the diagonal
///   or twice the precision, to where another point of the file was;
/// - pieces that hang on other surfaces by edges of three faces, and end freely, go (drop_flaps);
/// - faces are turned so that neighbours agree, in each connected surface the fewer;
/// - holes are filled with triangles over their own edges (CGAL's triangulate_hole_polyline: the
///   flattest patch): no points are made up. Holes that touch in a point are taken one by one;
/// - surfaces that are still open, and bound nothing, go (drop_debris);
/// - closed surfaces that touch, overlap or pass through themselves become the surface of what they
///   wind around at least once (resolve_overlaps.hpp).
///
/// Whether the result bounds a solid is not promised: import_solid judges it like any other.
///
/// n log n for n face corners, and quadratic in kMostHoleEdges. Throws nothing but what memory
/// does. REQUIRES: soup as from read_mesh, with its precision.
Repair repair(PolygonSoup soup);

}  // namespace spoctree
