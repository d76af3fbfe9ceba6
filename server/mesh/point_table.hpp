// Numbers points so that equal ones get the same number: STL's corners into shared vertices.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace spoctree {

/// A hash table over a vector of points that it fills. Two points are the same when all three
/// coordinates compare equal; -0.0 is stored as 0.0, so that equal points have equal bits. Numbers
/// are given in the order of first sight, whatever the table's size.
/// REQUIRES: coordinates are not NaN; `points` is empty at first, outlives the table and is changed
/// by it only.
class PointTable {
 public:
  explicit PointTable(std::vector<glm::dvec3>& points);

  /// The number of `point` in the vector, after adding it if it is new. Amortised O(1).
  std::uint32_t find_or_add(glm::dvec3 point);

 private:
  void grow();

  std::vector<glm::dvec3>& points_;
  std::vector<std::uint32_t>
      slots_;  // point number or kFree; a power of two of them, at most half full
};

}  // namespace spoctree
