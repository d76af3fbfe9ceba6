// Triangles without area out of a soup.
#pragma once

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/first_found.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

/// Drops triangles whose three points are on one line, exactly. The face on the other side of the
/// longest edge gets the middle point as a new corner, so that it meets the faces at the two
/// shorter edges; at a border edge there is none. The surface stays the same set of points. What
/// has more than one face beyond that edge, or another triangle without area that cannot be
/// dropped, stays. n log n, for the first kMostNeedleRounds of needles that lie against needles.
FirstFound<FacePlace> drop_needles(PolygonSoup& soup);

inline constexpr int kMostNeedleRounds = 32;

}  // namespace spoctree
