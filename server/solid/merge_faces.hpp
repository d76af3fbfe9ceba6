// Neighbouring triangles that are flat within a tolerance -> one flat face, its corners moved onto
// its plane.
#pragma once

#include "server/solid/box_tree.hpp"
#include "server/solid/flat_tolerance.hpp"
#include "server/solid/grid_mesh.hpp"
#include "server/solid/grid_plane.hpp"
#include "server/solid/shells.hpp"

namespace spoctree {

/// Triangles that bound a solid, each with its plane: its corners are within a few steps of the
/// grid of it.
struct PlanarSurface {
  GridMesh mesh;
  std::vector<Corners> neighbours;
  std::vector<GridPlane> planes;  ///< equal for triangles that were made one face
  ShellJudgement shells;
  std::size_t planes_before_merging = 0;
  double largest_move = 0;  ///< of a corner, universe units
};

/// Merges what lies within tolerance.spread of one plane and moves corners by less than twice that,
/// or what rounding explains, by less than that explains (tolerance.most_move()): no point farther
/// than that from the surface changes sides. What comes out has been judged like what went in;
/// where moved corners would make triangles vanish, turn over or meet others, they stay where they
/// were, and what they belong to is merged no further than that allows; where merging saves next to
/// no planes, the surface stays as it was (merging_gain.hpp). There are never more planes than
/// before. In the worst case nothing is merged. With no tolerance nothing moves. Near-linear.
/// REQUIRES: a judged surface that faces outwards, `boxes` of its triangles; 0 <= tolerance.spread
/// < 0.5, and so each rounding.
PlanarSurface merge_faces(GridMesh mesh, std::vector<Corners> neighbours, const BoxTree& boxes,
                          const ShellJudgement& shells, const FlatTolerance& tolerance);

}  // namespace spoctree
