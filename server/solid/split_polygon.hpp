// A polygon of the plane into triangles.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "server/solid/grid_mesh.hpp"

namespace spoctree {

/// Appends triangles that fill, counter-clockwise, the area around which the polygon winds. `face`
/// has the numbers of its corners, `points` where they are: a number that stands several times is
/// one point. The polygon need not be simple: where it runs along an edge as often in one direction
/// as in the other (the bridge to a hole) that edge bounds nothing, and it may touch itself in
/// corners. But it has to wind once around every point of one area and not at all around all
/// others, and all its corners have to lie in that area or on its border. That is decided exactly:
/// the triangles' edges that have no second triangle are the polygon's edges, each once, and no
/// others. False, and no triangles, for any other polygon. n log n.
bool split_polygon(std::span<const glm::dvec2> points, std::span<const std::uint32_t> face,
                   std::vector<Corners>& triangles);

}  // namespace spoctree
