// The six kinds of node of an SP-Octree (Cano, Torres, Velasco, WSCG 2003, section 2).
#pragma once

#include <cstdint>

namespace spoctree {

/// Let C be the node's cube, A the intersection of the half-spaces of its ancestors and P its own.
/// The node speaks about C n A only; outside A it may say anything. The material inside C n A is
/// White: nothing - Black: everything - Grey: the union of the eight children, clipped by P -
/// Convex: the intersection of P - Concave: the union of P - Vertex: an expression over P.
/// The values are those on the wire.
enum class NodeKind : std::uint8_t {
  White = 0,
  Black = 1,
  Grey = 2,
  Convex = 3,
  Concave = 4,
  Vertex = 5
};

inline constexpr int kNodeKindCount = 6;

/// Lower-case names, as in the JSON of `levels`.
inline constexpr const char* kNodeKindNames[kNodeKindCount] = {"white",  "black",   "grey",
                                                               "convex", "concave", "vertex"};

inline const char* name_of(NodeKind kind) { return kNodeKindNames[static_cast<int>(kind)]; }

}  // namespace spoctree
