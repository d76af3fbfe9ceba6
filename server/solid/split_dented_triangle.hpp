// A triangle with corners put into its sides into triangles, whatever rounding has made of it.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace spoctree {

/// Triangles over the corners of a polygon that was a triangle before corners were put into its
/// sides, up to `tolerance` off them: as if these were on the sides, with the thickest first. All
/// edges of the polygon are kept, and the triangles run around as it does. Empty if the polygon is
/// simple, seen along the axis nearest to its normal (there is nothing to do), if it was no
/// triangle, or if it has more than kMostDents corners. n log n, then quadratic in the corners.
std::vector<std::array<std::uint32_t, 3>> split_dented_triangle(
    std::span<const std::uint32_t> polygon, std::span<const glm::dvec3> points, double tolerance);

inline constexpr std::size_t kMostDents = 500;

}  // namespace spoctree
