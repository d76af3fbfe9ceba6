// A rebuilt surface -> its shells: the pieces of boundary that hang together.
#pragma once

#include <vector>

#include "client/rebuild/surface.hpp"

namespace spoctree {

/// The boundary between one connected piece of material and one connected piece of emptiness.
struct Shell {
  /// What it encloses, in universe units; negative if the material is outside: a cavity.
  double volume = 0;
  double area = 0;
  std::uint32_t face_count = 0;
};

/// The shells in the order of their first faces. Faces hang together where two of them, and no
/// more, share an edge: bodies that touch in an edge or a vertex only have a shell each.
/// O(surface).
std::vector<Shell> find_shells(const Surface& surface);

}  // namespace spoctree
