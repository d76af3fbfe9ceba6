// Triangles without area out of a soup.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/first_found.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

/// The corners of a triangle that is to be taken for a line, the middle one second; or nothing.
using LineOfTriangle =
    std::function<std::optional<std::array<std::uint32_t, 3>>(std::span<const std::uint32_t>)>;

/// Drops triangles whose three points are on one line, exactly; or others that `line_of` names. The
/// face on the other side of the longest edge gets the middle point as a new corner, so that it
/// meets the faces at the two shorter edges, and needles that lie against each other hand on each
/// other's points; at a border edge there is nobody to get them. The surface stays the same set of
/// points. What has more than one face beyond that edge stays, and what lies there with it.
/// n log n, in at most kMostNeedleRounds rounds (two needles may share their longest edge).
FirstFound<FacePlace> drop_needles(PolygonSoup& soup);
FirstFound<FacePlace> drop_needles(PolygonSoup& soup, const LineOfTriangle& line_of);

inline constexpr int kMostNeedleRounds = 32;

/// What drop_needles goes by unless told otherwise.
std::optional<std::array<std::uint32_t, 3>> exact_line(const PolygonSoup& soup,
                                                       std::span<const std::uint32_t> face);

}  // namespace spoctree
