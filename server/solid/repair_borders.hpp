// Edges that lack a partner, because the corners of the faces that should meet in them differ by
// rounding or lie within each other's edges, into edges that have one.
#pragma once

#include <glm/vec3.hpp>

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/first_found.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

/// A crack is closed if it is nowhere wider than this, as a fraction of the bounding box's
/// diagonal, or than twice the file's precision; wider ones are holes.
inline constexpr double kWidestCrack = 1e-4;

/// The precision of a file counts up to this, as a fraction of the diagonal: one that is coarser
/// says nothing about which corners are the same.
inline constexpr double kCoarsestPrecision = 0.005;

/// Two edges are one only if their ends are nearer to each other than this, as a fraction of the
/// length of either: within the precision, and beyond it, where more evidence is wanted.
inline constexpr double kNearEnds = 0.25;
inline constexpr double kNearEndsOfCrack = 0.0625;

/// Faces that lie on each other rather than side by side, their directions from the edge being as
/// near as this (cosine, 8 degrees), are the two sides of something thin and do not meet there.
inline constexpr double kFoldedFaces = 0.99;

/// A point by its number in the soup of the moment.
struct PointPlace {
  std::uint32_t number = 0;
  glm::dvec3 point{};
  auto operator<=>(const PointPlace& other) const { return number <=> other.number; }
  bool operator==(const PointPlace& other) const { return number == other.number; }
};

struct MendedBorders {
  FirstFound<PointPlace> merged;    ///< points that became another one
  double farthest_merged = 0;       ///< the distance between two such, in units of the file
  FirstFound<FacePlace> collapsed;  ///< faces of which fewer than three corners were left by that
  FirstFound<PointPlace> inserted;  ///< points put into an edge; once for each face
  double farthest_inserted = 0;     ///< the distance of one of them from the edge
  FirstFound<FacePlace> slivers;    ///< triangles thinner than the precision, dropped
};

/// Looks at open edges only (with an odd number of faces), and at nothing else in the soup. For
/// ever larger distances, from 2^-50 of the diagonal to kWidestCrack:
/// - corners are made one where edges match: both ends of one are within the distance of both ends
///   of the other, and the faces do not lie on each other. All that are joined by matching edges
///   become the one of them that most corners have; none of them, if they are spread wider than
///   twice the distance. So no order of points or faces matters, and nothing drifts.
/// - a corner that lies within the distance of an open edge, and whose own open edge goes on along
///   it, becomes a corner of the faces there (T-junctions).
/// - triangles no thicker than `precision` that have an open edge, when nothing else helps, are
///   dropped (within the precision only): the file cannot say what they are.
///
/// A soup without open edges stays as it is. n log n for n open edges, some 20 times; where very
/// many of them crowd in one place, a step is left out.
/// `precision` is the unit of the last digit of the file, in its units; 0 if it is not known.
MendedBorders mend_borders(PolygonSoup& soup, double precision);

}  // namespace spoctree
