// The connected surfaces of a mesh: what each encloses, and whether they face the right way for how
// they nest.
#pragma once

#include "server/solid/box_tree.hpp"
#include "server/solid/grid_mesh.hpp"

namespace spoctree {

struct ShellJudgement {
  std::size_t shells = 0;
  /// The first triangle of each shell that faces the wrong way for how the shells nest.
  std::vector<std::uint32_t> wrong;
  double volume = 0;  ///< enclosed material in cubed universe units; negative if all are wrong

  /// Every shell faces the wrong way: reversing all makes a solid.
  bool is_inside_out() const { return !wrong.empty() && wrong.size() == shells; }
};

/// A shell within an even number of others must enclose material, one within an odd number must
/// bound a cavity. Exact: volumes are summed in integers, nesting is decided by UpwardRay. The
/// volume is rounded once, at the end. Near-linear for few shells.
/// REQUIRES: neighbours as from find_neighbours, no self-intersections, boxes of the triangles.
ShellJudgement judge_shells(const GridMesh& mesh, const std::vector<Corners>& neighbours,
                            const BoxTree& boxes);

}  // namespace spoctree
