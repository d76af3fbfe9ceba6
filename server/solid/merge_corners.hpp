// Points of a soup that have become one: its faces, renamed, and what is left of those that touch
// themselves by that.
#pragma once

#include <span>
#include <vector>

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/first_found.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

/// Gives every corner c the number new_number[c]. A corner that has become equal to the one before
/// it is left out; a face that now has a point twice is divided there, which as a chain it is
/// already; what has fewer than three corners then goes. Faces keep their order. The points stay,
/// used or not. Linear in the corners, but for long faces that touch themselves (k log k).
/// `origin`, if given, has an entry for each face, which its parts inherit.
/// Returns the faces of which nothing is left, under their number and corners of before.
FirstFound<FacePlace> merge_corners(PolygonSoup& soup, std::span<const std::uint32_t> new_number,
                                    std::vector<std::uint32_t>* origin = nullptr);

}  // namespace spoctree
