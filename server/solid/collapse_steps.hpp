// Steps far lower than the flat tolerance out of a closed surface of triangles: what is left where
// faces of several parts were meant to lie in one plane, and nearly do.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/solid/grid_mesh.hpp"

namespace spoctree {

/// What a point may be made one with: a fixed point with loose and made ones only. A cluster
/// becomes a fixed point if it has one, else a loose one.
enum class StepPoint : std::uint8_t { Made, Loose, Fixed };

/// Makes points one that are within `distance` of each other, and puts points that are so near to
/// an edge into it; at least one point of those that meet is not fixed. Triangles that are lines or
/// cancel each other out by this go; no others are left that are thinner than `distance`, as far as
/// a few rounds find them. Points do not move; a surface that was closed stays closed, for edges
/// are renamed or divided alike in all their triangles. It may meet itself afterwards. Clusters do
/// not depend on the order of the points, and are not wider than kWidestStep distances; a wider
/// chain is left. n log n where few points are near an edge.
/// `source` goes with `triangles`. Returns whether anything was changed.
bool collapse_steps(std::span<const Vec3> points, std::span<const StepPoint> kinds, double distance,
                    std::vector<Corners>& triangles, std::vector<std::uint32_t>& source);

inline constexpr double kWidestStep = 4;

}  // namespace spoctree
