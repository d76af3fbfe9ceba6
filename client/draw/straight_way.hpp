// Points one after the other -> how long they go straight on.
#pragma once

#include "client/lines/camera.hpp"

namespace spoctree {

/// A straight line that gets longer, and all points on its way lie within a tolerance of it: also
/// those of a fine arc, whose every corner alone would pass for none.
class StraightWay {
 public:
  StraightWay(Vec2 begin, Vec2 end, double tolerance);

  /// True if the line may end at `end` instead, which lies farther on. O(1).
  bool go_on_to(Vec2 end);

 private:
  double along(Vec2 point) const { return glm::dot(direction_, point - begin_); }
  /// How much the line to a point rises from the direction in which it set out.
  double slope(Vec2 point) const;
  void keep_to(Vec2 point);

  Vec2 begin_;
  Vec2 direction_{0.0};  ///< unit, or 0 for a point
  double tolerance_;
  double reach_ = 0;
  double least_slope_;
  double most_slope_;
};

}  // namespace spoctree
