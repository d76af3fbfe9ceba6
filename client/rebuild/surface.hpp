// The boundary of T_k, rebuilt from the tree's planes alone: a closed polygon mesh and its creases.
//
// Cells -> corners by the planes that meet there (corners), where almost all cancels -> ends of
// edges on every line (line_ends) -> a chain of edges per plane (chain), cleaned up
// (settle_vertices, contacts) -> loops and faces (face_builder) -> creases. chain.hpp says why the
// result is always closed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/tree/octree.hpp"

namespace spoctree {

/// A closed, oriented surface of plane faces. Every directed edge of a loop is met by as many
/// opposite ones. Vertices in universe coordinates (Universe::to_model turns them into the
/// model's).
struct Surface {
  /// A cycle of distinct vertices: `count` (>= 3) entries of `loop_vertices` from `first` on.
  struct Loop {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    bool operator==(const Loop&) const = default;
  };
  /// A connected plane region. Its first loop is the outer one, counter-clockwise seen from
  /// outside; the others are holes, clockwise. Loops of one face may touch in vertices, not cross.
  struct Face {
    PlaneRef plane;  ///< normal outwards: a plane of the table or a cell wall, either way round
    std::uint32_t first_loop = 0;
    std::uint32_t loop_count = 0;
    bool operator==(const Face&) const = default;
  };
  /// A face beside an edge; `forward` if its loop runs from `a` to `b`.
  struct Side {
    std::uint32_t face = 0;
    bool forward = false;
    bool operator==(const Side&) const = default;
  };
  /// A crease: a straight edge of the boundary, each once, a < b. Two sides of different direction
  /// as a rule, four where the solid is not a manifold.
  struct Edge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t first_side = 0;
    std::uint32_t side_count = 0;
    bool operator==(const Edge&) const = default;
  };

  std::vector<Vec3> vertices;
  std::vector<std::uint32_t> loop_vertices;
  std::vector<Loop> loops;
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Side> sides;

  std::span<const std::uint32_t> vertices_of(const Loop& loop) const {
    return {loop_vertices.data() + loop.first, loop.count};
  }
  std::span<const Loop> loops_of(const Face& face) const {
    return {loops.data() + face.first_loop, face.loop_count};
  }
  std::span<const Side> sides_of(const Edge& edge) const {
    return {sides.data() + edge.first_side, edge.side_count};
  }
  bool operator==(const Surface&) const = default;
};

/// The boundary of T_level; levels beyond the tree mean its last level. The combinatorics are
/// closed whatever the rounding; vertices closer than kWeldTolerance are one vertex, and features
/// thinner than that may vanish. Neither cell walls nor splits of a node leave an edge in a flat
/// face, and an edge that runs straight through many cells is one edge. Same levels, same bytes.
/// REQUIRES: a valid tree (validate.hpp). Throws std::logic_error, naming the place, if the result
/// is not closed (a bug). In parallel; time O(nodes) as a rule, memory O(boundary).
Surface rebuild_surface(const Octree& tree, std::uint32_t level = static_cast<std::uint32_t>(-1));

/// Volume enclosed and area, by the divergence theorem, in universe units.
double volume(const Surface& surface);
double area(const Surface& surface);

}  // namespace spoctree
