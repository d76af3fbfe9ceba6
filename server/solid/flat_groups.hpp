// Triangles into groups that are to lie in one plane.
#pragma once

#include "server/solid/flat_surface.hpp"

namespace spoctree {

/// Triangles that are to lie in one plane, connected or not.
struct FlatGroup {
  GridPlane plane;
  double area = 0;       ///< universe units
  bool is_exact = true;  ///< the planes of all its triangles are equal to `plane` already
  std::vector<std::uint32_t> triangles;
};

struct FlatGroups {
  std::vector<FlatGroup> groups;           ///< each of at least two triangles
  std::vector<std::uint32_t> of_triangle;  ///< kNone: in no group
};

/// Neighbours that are flat within the tolerance (grow_patches), patches of these in one plane
/// within the tolerance (share_planes), and triangles anywhere whose planes are equal already. That
/// single triangles far from each other lie in one plane within a tolerance says nothing about
/// them: of the many small ones of a scan, some always do. n log n.
FlatGroups find_flat_groups(const FlatSurface& surface, double tolerance);

}  // namespace spoctree
