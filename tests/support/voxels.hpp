// Solids of equal cubes: their classical octree, and their boundary cube face by cube face.
#pragma once

#include <functional>

#include "client/rebuild/surface.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// The cells of a cubic grid of 2^depth cells a side; `contains(x, y, z)` says which are material.
struct Voxels {
  int depth = 0;
  std::function<bool(int, int, int)> contains;

  int side() const { return 1 << depth; }
  bool operator()(int x, int y, int z) const {
    const int n = side();
    return x >= 0 && y >= 0 && z >= 0 && x < n && y < n && z < n && contains(x, y, z);
  }
};

/// BLACK, WHITE and GREY nodes only. With `merged` false every cell is a leaf at the last level,
/// also where eight siblings are alike.
Octree tree_of(const Voxels& voxels, bool merged = true);

/// One face per boundary square of a cell and one edge per cell side with a crease: the many short
/// pieces that long lines have to be made of. Found from the cells, not from the tree.
Surface surface_of(const Voxels& voxels, double half_side = 1);

/// A Menger sponge's cells: 3^order cells a side, at the lower corner of the grid.
bool in_menger_sponge(int x, int y, int z, int order);

}  // namespace spoctree
