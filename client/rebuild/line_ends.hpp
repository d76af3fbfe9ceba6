// Pieces -> on every line in which two planes meet, where the edges of their faces begin and end.
//
// What counts on a line is the sum of the edges there, and a sum of intervals of one line is known
// from their ends alone: [a, b] + [b, c] = [a, c], whatever the order of a, b and c. So every piece
// says for each corner of its faces "here an edge on this line ends, here one begins", and almost
// everything cancels: the faces that two pieces share, the splits of a node, cell walls across a
// flat face, and the walls that a crease passes straight through.
#pragma once

#include <cstdint>
#include <vector>

#include "client/rebuild/carriers.hpp"
#include "client/rebuild/vertex_welder.hpp"
#include "common/tree/octree.hpp"

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

struct LineEnds {
  std::vector<LineEnd> ends;  ///< not all different
  /// Per carrier the sides on which pieces have faces: bit 0 and bit 1.
  std::vector<std::uint8_t> sides;
};

/// The ends of all edges of the pieces of T_level. What cancels within a cell is summed up there,
/// cell by cell from the leaves to the root, so that the working set stays small. O(pieces).
LineEnds collect_line_ends(const Octree& tree, std::uint32_t level, Carriers& carriers,
                           VertexWelder& welder);

}  // namespace spoctree
