// Triangles of one plane, with lines in which others meet them -> the pieces between the lines.
#pragma once

#include <vector>

#include "server/solid/arrangement.hpp"
#include "server/solid/meeting_lines.hpp"

namespace spoctree {

/// Appends the pieces of `members` (triangles that lie in one plane), constrained Delaunay. Points
/// in which lines cross are constructed; pairs of numbers that turn out to be one point are
/// appended to `same`. Throws TooEntangled.
void split_in_plane(ExactPoints& points, std::span<const Vec3> given,
                    std::span<const Corners> triangles, std::span<const std::uint32_t> members,
                    std::span<const MeetingLine> lines, std::vector<Piece>& pieces,
                    std::vector<std::array<std::uint32_t, 2>>& same);

}  // namespace spoctree
