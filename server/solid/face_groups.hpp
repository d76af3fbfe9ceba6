// Faces joined into groups, pair by pair.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace spoctree {

/// Disjoint sets of faces. Nearly constant time per call.
class FaceGroups {
 public:
  explicit FaceGroups(std::size_t faces) : parent_(faces) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  /// The face that stands for the group of `face`: its first.
  std::uint32_t group_of(std::uint32_t face) {
    while (parent_[face] != face) {
      parent_[face] = parent_[parent_[face]];
      face = parent_[face];
    }
    return face;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = group_of(a);
    b = group_of(b);
    parent_[a > b ? a : b] = a > b ? b : a;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace spoctree
