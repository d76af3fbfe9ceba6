// Cells, openings, and a viewer -> the parts of creases that are seen.
//
// An avenue of sight begins in the cell of the eye, with the picture as its mask. What lies on the
// cell's boundary within the mask is seen, for a convex cell hides nothing; through each opening
// the avenue goes on with the part of the mask that the opening leaves, until nothing is left.
// After C. B. Jones, A new approach to the 'hidden line' problem, Computer Journal 14 (3), 1971.
#pragma once

#include <cstdint>
#include <vector>

#include "client/cells/cell_creases.hpp"
#include "client/cells/empty_space.hpp"
#include "client/lines/camera.hpp"
#include "common/base/progress_meter.hpp"

namespace spoctree {

/// What a picture took.
struct AvenueCounts {
  std::uint64_t avenues = 0;  ///< cells seen, each as often as through different openings
  std::uint64_t cells = 0;    ///< each once
  std::uint32_t longest = 0;  ///< the most openings that an avenue goes through
};

/// The parts of the wanted creases that are seen within `frame`; they may overlap. The avenues'
/// masks divide the picture, so their number is bounded by it alone: those thinner than
/// kThinnestMask end. Each takes time linear in the corners of its cell's openings and in the
/// creases that touch the cell. Cells that no avenue leads to are not looked at. An eye on the
/// border of several cells begins in all of them; one outside the universe cube, or a parallel
/// view, at the cube's walls. Throws what `progress` throws.
std::vector<CreasePart> find_parts_in_avenues(const EmptySpace& space, const CellCreases& parts,
                                              const Creases& creases,
                                              const std::vector<bool>& is_wanted,
                                              const Camera& camera, const Rectangle& frame,
                                              AvenueCounts* counts = nullptr,
                                              const ProgressShare& progress = {});

}  // namespace spoctree
