// Corners of the boundary -> on every line in which two planes meet, where edges begin and end.
//
// What counts on a line is the sum of the edges there, and a sum of intervals of one line is known
// from their ends alone: [a, b] + [b, c] = [a, c], whatever the order of a, b and c. A corner says
// on each of its three lines "here an edge ends", or begins. In a vertex of the solid with more
// than three planes, the rounded planes meet in a cluster of corners: they become one vertex, and
// what they say on the same line cancels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/rebuild/carriers.hpp"
#include "client/rebuild/corner_sum.hpp"
#include "client/rebuild/vertex_welder.hpp"

namespace spoctree {

/// On the line in which the carriers `low` < `high` meet, the edges of faces on `low` (run
/// counter-clockwise seen from outside their pieces) end in `vertex` as many times more than they
/// begin there as `count` says. The edges of faces on `high` do the opposite: an edge of a piece
/// has a face on either, and they run along it in opposite directions.
struct LineEnd {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t vertex = 0;
  std::int32_t count = 0;
};

/// The line ends of all corners, each line and vertex once, by vertex. Gives carriers to the walls
/// among the corners' planes, and vertices to the corners. O(corners).
std::vector<LineEnd> find_line_ends(std::span<const CornerCount> corners, Carriers& carriers,
                                    VertexWelder& welder);

}  // namespace spoctree
