// Trees for tests that need no builder: by hand, and random ones.
#pragma once

#include <cstdint>
#include <span>

#include "common/tree/octree.hpp"
#include "tests/support/random.hpp"

namespace spoctree {

/// A cube of side 2 mm around (10, 20, 30): one CONVEX root with six planes.
Octree cube_tree();

/// A GREY root with one of each kind below it, and a level below its second GREY node. 17 nodes.
Octree every_kind_tree();

/// One CONVEX root with `plane_count` different planes around a ball.
Octree many_planes_tree(std::uint32_t plane_count);

struct RandomTreeOptions {
  std::uint32_t levels = 4;       ///< at most
  std::uint32_t max_nodes = 500;  ///< no GREY nodes beyond about so many
  double grey_chance = 0.5;       ///< the root is GREY if `levels` > 1
  double reuse_chance = 0.7;      ///< that a reference is to a plane of the table
  std::uint32_t max_planes_per_node = 5;
};

/// A valid tree (validate finds nothing): random kinds, planes through their cells and on the
/// grid, expressions. The same for the same arguments, everywhere.
Octree random_tree(std::uint64_t seed, const RandomTreeOptions& options = {});

/// A plane on the grid through a point of the cube `center` +- `half` (universe coordinates).
Plane random_plane(Random& random, Vec3 center, double half);

/// True if the trees are equal in every column.
bool are_equal(const Octree& a, const Octree& b);

}  // namespace spoctree
