// Corners in ascending order of their planes: the same sums in the same order, whatever order they
// were found in.
#pragma once

#include <cstdint>
#include <vector>

#include "client/rebuild/corner_sum.hpp"

namespace spoctree {

/// Sorts corners, adds up those of the same planes and drops what becomes zero. Planes with numbers
/// below `common` are those that most corners have (they are not cell walls): corners with one take
/// O(corners + common) if each plane has a few of them, others O(n log n). In parallel.
void sort_corners(std::vector<CornerCount>& corners, std::uint32_t common);

/// The sums of two sorted lists, sorted. O(a + b).
std::vector<CornerCount> add_sorted_corners(const std::vector<CornerCount>& a,
                                            const std::vector<CornerCount>& b);

}  // namespace spoctree
