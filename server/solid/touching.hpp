// Where a solid touches itself in edges and points: which faces go on with which there, and a
// manifold of them while corners are being moved.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "server/solid/grid_mesh.hpp"

namespace spoctree {

/// The triangles along one edge, in pairs that bound one wedge of material, if they do: an even
/// number that alternate in direction around the edge. Exact. `half_edges` are 3 t + i for the edge
/// from corner i of triangle t to the next. n log n. REQUIRES: no degenerate triangle.
std::optional<std::vector<std::array<std::uint32_t, 2>>> pair_around_edge(
    const GridMesh& mesh, const std::vector<std::uint32_t>& half_edges);

/// Gives every fan of triangles around a point but the first its own copy of the point
/// (mesh.copy_of), and notes in mesh.touching the points with copies, the copies, and the ends of
/// edges with more than two triangles. Linear, but for sorting edges.
void separate_fans(GridMesh& mesh, const std::vector<Corners>& neighbours);

/// The triangles with points in place of their copies.
std::vector<Corners> without_copies(const GridMesh& mesh, const std::vector<Corners>& triangles);

}  // namespace spoctree
