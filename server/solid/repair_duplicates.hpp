// Faces that stand more than once in a soup: their copies go, and sometimes they do.
#pragma once

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/first_found.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

struct DroppedDuplicates {
  FirstFound<FacePlace> copies;      ///< faces of which an earlier one is left
  FirstFound<FacePlace> partitions;  ///< faces of which none is left
};

/// Drops copies of faces (the same corners in the same order or its reverse). Connected faces that
/// have copies are looked at together: where most of the edges around them have two other faces,
/// which then belong to each other, they are a wall between two parts of the solid, and none of
/// them stays; else one of each stays. n log n.
DroppedDuplicates drop_duplicate_faces(PolygonSoup& soup);

}  // namespace spoctree
