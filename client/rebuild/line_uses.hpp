// Pieces -> what their faces' edges say on every line in which two planes meet.
//
// A face that two pieces share, the same corners on the same lines, is dropped at once: most faces
// on cell walls go this way.
#pragma once

#include <cstdint>
#include <vector>

#include "client/rebuild/carriers.hpp"
#include "client/rebuild/vertex_welder.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// A directed edge of a piece's face, counter-clockwise around the face seen from outside the
/// piece.
struct LineUse {
  std::uint32_t low;  ///< the two carriers of the line, low < high
  std::uint32_t high;
  std::uint32_t from;  ///< vertices
  std::uint32_t to_and_face;
  static constexpr std::uint32_t kOnHigh = 1u << 31;  ///< the face lies on `high`, else on `low`

  std::uint32_t to() const { return to_and_face & ~kOnHigh; }
  bool is_on_high() const { return (to_and_face & kOnHigh) != 0; }
};

struct LineUses {
  std::vector<LineUse> uses;
  /// Per carrier the sides on which faces lie: bit 0 and bit 1.
  std::vector<std::uint8_t> sides;
};

/// The edges of the faces of all pieces of T_level, but for faces that cancel. The sum of all uses
/// is a closed chain: every piece has each of its edges twice, once each way, on the same line.
LineUses collect_line_uses(const Octree& tree, std::uint32_t level, Carriers& carriers,
                           VertexWelder& welder);

}  // namespace spoctree
