// Whether faces close, as a witness: what was read in an unusual way has come out whole.
#pragma once

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Whether, with equal points made one, every edge has an even number of faces, and there is a
/// face. Values taken for others, faces that are missing and bytes that are none leave edges with
/// an odd number. n log n in the corners.
bool is_closed_surface(PolygonSoup soup);

}  // namespace spoctree
