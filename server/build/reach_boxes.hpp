// "Does any of these points lie beyond that plane, for certain?", fast for many points and planes.
#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/plane.hpp"

namespace spoctree {

/// Points known to within an error, with a bounding-box tree over them.
class ReachBoxes {
 public:
  void clear() { points_.clear(); }
  void add(Vec3 position, double error) { points_.push_back({position, error}); }
  /// Call after the last add. O(n log n).
  void prepare();
  /// True if dot(normal, p) > offset + doubt + 2 * error for some point p. Visits the boxes that
  /// the plane passes, or that are beyond it, until the first hit.
  bool any_beyond(Vec3 normal, double offset, double doubt) const;

 private:
  struct Point {
    Vec3 position{0.0};
    double error = 0;
  };
  struct Box {
    Vec3 centre{0.0};
    Vec3 half{0.0};
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t right = 0;  ///< index of the right child; the left one is the next; 0 for a leaf
  };
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  std::vector<Point> points_;
  std::vector<Box> boxes_;
};

}  // namespace spoctree
