// "Is any of these corners beyond that plane?", fast for many corners and many planes.
#pragma once

#include <cstdint>
#include <vector>

#include "server/build/fragment.hpp"

namespace spoctree {

/// A set of fragment corners with a bounding-box tree over it. Building is O(n log n) (nothing for
/// small sets); a query visits the boxes that the plane passes or that lie beyond it until the
/// first hit: O(log n + corners near the plane) in practice.
class CornerSet {
 public:
  void clear();
  void add(const FragmentCorner& corner, std::uint32_t triangle) {
    items_.push_back({&corner, triangle});
  }
  /// Call after the last add. The corners must stay where they are.
  void prepare();
  /// True if some corner lies strictly on side `sign` (+1 or -1) of the plane.
  bool any_on_side(std::uint32_t plane, int sign, const Plane& coefficients,
                   const CornerSides& sides);

 private:
  struct Item {
    const FragmentCorner* corner;
    std::uint32_t triangle;
  };
  struct Box {
    Vec3 centre{0.0};
    Vec3 half{0.0};
    double error = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t right = 0;  ///< index of the right child; the left one is the next; 0 for a leaf
  };
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  std::vector<Item> items_;
  std::vector<Box> boxes_;
  /// Where a corner was found last: often the next plane has it on the same side.
  std::uint32_t last_hit_ = 0;
};

}  // namespace spoctree
