// The connected surfaces of a mesh: what each encloses, and whether they face the right way for how
// they nest.
#pragma once

#include "server/solid/box_tree.hpp"
#include "server/solid/grid_mesh.hpp"

namespace spoctree {

struct ShellJudgement {
  bool is_inside_out = false;  ///< every shell faces the wrong way: reversing all makes a solid
  double volume = 0;           ///< enclosed material, positive, in cubed universe units
};

/// A shell within an even number of others must enclose material, one within an odd number must
/// bound a cavity. Exact: volumes are summed in integers, nesting is decided by UpwardRay. The
/// volume is rounded once, at the end. Near-linear for few shells.
/// Throws BadInput if some shells face the right way and others do not.
/// REQUIRES: neighbours as from find_neighbours, no self-intersections, boxes of the triangles.
ShellJudgement judge_shells(const GridMesh& mesh, const std::vector<Corners>& neighbours,
                            const BoxTree& boxes);

}  // namespace spoctree
