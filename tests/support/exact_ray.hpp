// A ray through the definition of a tree, in rational numbers: what ray queries are judged by.
#pragma once

#include <vector>

#include "common/tree/octree.hpp"
#include "tests/support/exact.hpp"

namespace spoctree {

/// A part of a ray in which T_level says the same everywhere.
struct ExactSegment {
  enum class Content { Out, In, Unknown } content = Content::Out;
  Rational from;
};

/// The parts of the ray origin + t direction, t > 0, in order: neighbours differ, the first begins
/// at 0 and the last one goes on for ever. REQUIRES: the ray lies in no plane and no wall.
std::vector<ExactSegment> segments_of_definition(const Octree& tree, std::uint32_t level,
                                                 const RationalPoint& origin,
                                                 const RationalPoint& direction);

}  // namespace spoctree
