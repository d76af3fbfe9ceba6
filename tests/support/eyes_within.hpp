// Empty space -> places within a solid's hull to look around from.
#pragma once

#include <vector>

#include "client/cells/empty_space.hpp"

namespace spoctree {

struct EyeWithin {
  Vec3 at{0.0};  ///< universe coordinates
  bool is_in_cavity = false;
};

/// The middles of the largest cells: one in each of the largest cavities (what no way leads out
/// of), then others inside all planes of the root; at most `most`.
std::vector<EyeWithin> eyes_within(const EmptySpace& space, std::size_t most);

/// The cells from which a way through openings leads out of the universe cube, by number.
std::vector<bool> cells_open_to_outer_space(const EmptySpace& space);

}  // namespace spoctree
