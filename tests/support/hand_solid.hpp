// Solids without import: on dyadic coordinates in a universe cube of the test's choice, so that
// cell walls meet faces, edges and vertices exactly; with their own exact inside tests.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "server/solid/solid.hpp"
#include "tests/support/random.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {

/// The cube of half side 1 around the origin: universe coordinates are model coordinates.
Universe unit_universe();

/// The closed surface of these triangles, counter-clockwise from outside, as a solid; coplanar
/// neighbours are one facet. Points on the grid. Throws std::invalid_argument if the surface is not
/// closed and edge-manifold.
Solid hand_solid(std::vector<Vec3> points,
                 const std::vector<std::array<std::uint32_t, 3>>& triangles,
                 const Universe& universe = unit_universe());

Solid box_solid(Vec3 lower, Vec3 upper);

/// Both in one, the surfaces do not touch. `b` may be a cavity of `a` (see `turned`).
Solid together(const Solid& a, const Solid& b);
/// With the surface turned inside out: for cavities.
Solid turned(const Solid& solid);

/// The material of full voxels. REQUIRES: is_manifold(voxels).
Solid voxel_solid(const Voxels& voxels);
/// True if the boundary is a manifold: around every edge and every corner of the grid, full and
/// empty cells hang together.
bool is_manifold(const Voxels& voxels);
/// A random manifold set of 8^depth cells, about half of them full.
Voxels random_voxels(int depth, Random& random);

/// The space between z = bottom and a surface of triangles over a square grid.
struct HeightField {
  int cells = 0;  ///< along a side
  Vec3 corner{0.0};
  double step = 0;
  std::vector<double> heights;  ///< (cells + 1)^2, row by row, > corner.z

  double height(int x, int y) const {
    return heights[static_cast<std::size_t>(y * (cells + 1) + x)];
  }
  /// Exact for dyadic numbers of few bits; nothing for points on the surface or its vertical walls.
  std::optional<bool> is_inside(Vec3 point) const;
  double volume() const;
};

/// Heights are random multiples of `unit` from `lowest` on, `range` different ones.
HeightField random_height_field(int cells, Vec3 corner, double step, double lowest, double unit,
                                std::uint32_t range, Random& random);
Solid height_field_solid(const HeightField& field);

}  // namespace spoctree
