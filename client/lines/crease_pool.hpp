// Parts of creases that flow down the octree: each node takes from its parent what lies in its
// cube, each piece takes from its node what lies on it, and what is left goes back up.
#pragma once

#include <span>
#include <vector>

#include "client/lines/covered_region.hpp"
#include "client/lines/crease.hpp"

namespace spoctree {

/// A part of a crease: the points a + t (b - a), t in `interval`; and the sides from which it may
/// still turn out to be seen.
struct CreasePart {
  std::uint32_t crease = 0;
  LineSides sides = kBothSides;
  Interval interval;
};

/// One stack of parts; the frames of nested nodes are consecutive ranges of it.
class CreasePool {
 public:
  /// The root frame holds `parts`. What is nearer than `tolerance` to a region counts as in it.
  /// REQUIRES: `creases` outlives the pool.
  CreasePool(std::span<const Crease> creases, std::vector<CreasePart> parts, double tolerance)
      : creases_(creases), tolerance_(tolerance), parts_(std::move(parts)), frames_{0} {}

  /// True if no part is left in any frame.
  bool is_empty() const { return parts_.empty(); }
  /// True if the innermost frame is empty.
  bool frame_is_empty() const { return parts_.size() == frames_.back(); }

  /// Opens a frame with the parts of the innermost one that lie in the intersection of
  /// half-spaces. O(parts of the innermost frame).
  void open_frame(std::span<const Plane> half_spaces);
  /// Gives what is left in the innermost frame back to the one around it.
  void close_frame() { frames_.pop_back(); }
  /// Moves the parts of the innermost frame that lie in the half-spaces to the end of `taken`.
  void take(std::span<const Plane> half_spaces, std::vector<CreasePart>& taken);
  /// Puts a part into the innermost frame.
  void put_back(const CreasePart& part) { parts_.push_back(part); }

 private:
  std::span<const Crease> creases_;
  double tolerance_;
  std::vector<CreasePart> parts_;
  std::vector<std::size_t> frames_;  ///< where each frame begins
  std::vector<CreasePart> moved_;
  std::vector<CreasePart> rests_;
};

}  // namespace spoctree
