// What is known without arithmetic: which planes pass through which vertices of the solid.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "server/solid/solid.hpp"

namespace spoctree {

/// The planes around every vertex of a solid. O(n log n) to build, O(log n) to ask.
class Incidence {
 public:
  explicit Incidence(const Solid& solid);
  /// Planes of the facets around a vertex, in order.
  std::span<const std::uint32_t> planes_of(std::uint32_t vertex) const {
    return {planes_.data() + begin_[vertex], begin_[vertex + 1] - begin_[vertex]};
  }
  bool is_on(std::uint32_t vertex, std::uint32_t plane) const {
    const auto planes = planes_of(vertex);
    return std::binary_search(planes.begin(), planes.end(), plane);
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> planes_;
};

}  // namespace spoctree
