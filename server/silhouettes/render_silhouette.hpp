// Triangles -> their silhouette in one of the thirteen views.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "server/silhouettes/mask.hpp"
#include "server/silhouettes/views.hpp"

namespace spoctree {

/// A pixel is 1 if the line of sight through its centre meets a triangle, its border included
/// (section III-B): of a closed surface's triangles, if it meets the solid. Points are coordinates
/// in which the universe cube is [-1, 1]^3. In the picture they are rounded to 2^-16 of a pixel;
/// from there on the rule is exact, so that no line passes between neighbouring triangles.
/// O(triangles * their height in pixels, and pixels covered).
/// REQUIRES: points in [-2, 2]^3; width and height 1 to kMostMaskPixels.
Mask render_silhouette(const View& view, std::span<const glm::dvec3> points,
                       std::span<const std::array<std::uint32_t, 3>> triangles, int width,
                       int height);

}  // namespace spoctree
