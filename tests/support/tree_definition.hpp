// What a tree means, read off the table of definitions node by node: no clipping, no descent by
// comparison, nothing shared with the code under test.
#pragma once

#include <array>
#include <vector>

#include "common/tree/octree.hpp"
#include "tests/support/exact.hpp"

namespace spoctree {

/// The value of T_level at a place: `is_material` says whether it is in T_level, `is_known` whether
/// the levels 0..level are certain of it (they are not in what is left of a GREY node of the last).
struct TreeValue {
  bool is_material = false;
  bool is_known = true;
  bool operator==(const TreeValue&) const = default;
};

/// The value at `point`, or infinitely near to it in `direction` where planes and walls pass
/// through the point. REQUIRES: none of those contains the direction.
TreeValue value_of_definition(const Octree& tree, std::uint32_t level, const RationalPoint& point,
                              const RationalPoint& direction);

/// At least one direction into every region that the planes and walls through `point` divide the
/// space around it into, to be used with value_of_definition.
std::vector<RationalPoint> directions_around(const Octree& tree, std::uint32_t level,
                                             const RationalPoint& point);

}  // namespace spoctree
