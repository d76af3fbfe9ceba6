// Pairs of triangles that meet -> the points and lines in which they do.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "server/solid/exact_points.hpp"
#include "server/solid/grid_mesh.hpp"

namespace spoctree {

/// A part of a triangle that others meet: from a point to another, or one point twice.
struct MeetingLine {
  std::uint32_t triangle;
  std::array<std::uint32_t, 2> ends;
};

struct MeetingLines {
  std::vector<MeetingLine> lines;                      ///< sorted by triangle
  std::vector<std::array<std::uint32_t, 2>> in_plane;  ///< pairs that lie in one plane
};

/// Constructs, exactly, the points where an edge of one meets the other; a point gets one number
/// however many pairs tell of it, unless three triangles without a common edge meet there.
/// REQUIRES: no triangle is degenerate; `points` has been given the triangles' corners.
MeetingLines find_meeting_lines(ExactPoints& points, std::span<const Vec3> given,
                                std::span<const Corners> triangles,
                                std::span<const std::array<std::uint32_t, 2>> pairs);

}  // namespace spoctree
