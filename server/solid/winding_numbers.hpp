// The pieces of an arrangement -> how often the surface winds around what is on either side of them
// (Zhou, Grinspun, Zorin, Jacobson 2016, section 5).
#pragma once

#include <optional>

#include "server/solid/arrangement.hpp"
#include "server/solid/box_tree.hpp"

namespace spoctree {

/// The numbers in front of a piece, where its normal points, and behind it.
struct Winding {
  std::int32_t front;
  std::int32_t back;
};

/// Of each piece. Around every edge, the space between one piece and the next is one cell; from
/// cell to cell the number changes by `times`; one ray for each connected surface says where it
/// begins. Everything exact. Nothing if the triangles have a border: then there is no such number.
/// n log n. REQUIRES: `boxes` of the triangles that the arrangement was made of.
std::optional<std::vector<Winding>> find_winding_numbers(const Arrangement& arrangement,
                                                         std::span<const Vec3> points,
                                                         std::span<const Corners> triangles,
                                                         const BoxTree& boxes);

}  // namespace spoctree
