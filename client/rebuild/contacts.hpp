// Makes the boundary edges of every plane meet in vertices only.
#pragma once

#include "client/rebuild/chain.hpp"

namespace spoctree {

/// Cuts edges of the chain where, in a plane that both belong to, a vertex lies on them within the
/// welder's tolerance (then what lies on top of each other cancels: faces of no width vanish) or
/// where two of them cross (material on both sides of a cell wall, overlapping in part). An edge is
/// cut for all its planes alike, into shorter ones only, and never so that edges pile up: it ends
/// in a few rounds wherever the vertices are. Normalized before and after. Returns true if it cut
/// any. O(n log n) as a rule in the edges of a plane.
bool resolve_contacts(Chain& chain, const Carriers& carriers, VertexWelder& welder);

}  // namespace spoctree
