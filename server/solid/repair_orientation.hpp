// Faces that disagree about the outside into faces that agree.
#pragma once

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/first_found.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

struct TurnedFaces {
  FirstFound<FacePlace> faces;      ///< turned
  std::size_t one_sided_edges = 0;  ///< where the faces disagree whatever is turned
};

/// Turns faces until the two faces of every edge run along it in opposite directions, in each
/// connected surface the smaller number of them. Surfaces are connected across edges with two
/// faces; one-sided surfaces (Möbius strips) stay as they are. n log n.
TurnedFaces agree_on_outside(PolygonSoup& soup);

}  // namespace spoctree
