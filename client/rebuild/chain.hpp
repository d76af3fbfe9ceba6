// The boundary of the faces of every plane, as a chain of edges between vertices.
//
// Why the rebuilt surface is closed, whatever the rounding: every edge of a polyhedron belongs to
// two faces, once each way, and so it is in a sum. Replacing a vertex by another one (welding), an
// edge by a path (cutting a line at the ends on it, or an edge at a vertex near it) or a path by an
// edge (dropping a straight vertex) is done to all faces alike. So the sum over all faces stays
// zero on every edge, and what is traced into loops afterwards is closed. Tolerances only decide
// how well neighbours cancel. Which part of a plane is covered is never computed: its boundary says
// it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/rebuild/line_ends.hpp"

namespace spoctree {

/// The boundary of the faces on `carrier` runs `count` times from a to b (a < b), or back if
/// negative. Faces lie to the left, seen from the outside of the solid at that face.
struct ChainEdge {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t carrier = 0;
  std::int32_t count = 0;
};
using Chain = std::vector<ChainEdge>;

/// The entry of a chain for an edge from `from` to `to`.
inline ChainEdge directed_edge(std::uint32_t from, std::uint32_t to, std::uint32_t carrier,
                               std::int32_t count) {
  return from < to ? ChainEdge{from, to, carrier, count} : ChainEdge{to, from, carrier, -count};
}

/// Cuts every line at its ends, and gives what the faces' edges say on each part. `ends` are sorted
/// in place. The result is normalized. O(ends).
Chain subdivide_lines(std::vector<LineEnd>& ends, std::uint32_t carrier_count,
                      std::span<const Vec3> positions);

/// Sorts by edge, then carrier; adds up equal entries and drops those that become zero.
void normalize(Chain& chain, std::size_t vertex_count);

/// Adds `more`, in any order, to a normalized chain; the result is normalized, `more` is not kept.
/// O(chain + more): what stays as it was is not sorted again.
void add_to_chain(Chain& chain, Chain&& more, std::size_t vertex_count);

/// Drops the vertices in which nothing happens: two edges, with the same faces beside them. A plane
/// pair meets in one line, so the two edges are in line. Normalized before and after.
void join_straight_edges(Chain& chain, std::size_t vertex_count);

/// Calls visit(begin, end) for every run of entries with the same two vertices.
template <class Visit>
void for_each_edge(const Chain& chain, Visit&& visit) {
  for (std::size_t begin = 0, end = 0; begin < chain.size(); begin = end) {
    while (end < chain.size() && chain[end].a == chain[begin].a && chain[end].b == chain[begin].b) {
      ++end;
    }
    visit(begin, end);
  }
}

}  // namespace spoctree
