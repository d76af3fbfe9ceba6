#include "client/draw/straight_way.hpp"

#include <algorithm>
#include <limits>

namespace spoctree {

StraightWay::StraightWay(Vec2 begin, Vec2 end, double tolerance)
    : begin_(begin),
      tolerance_(tolerance),
      least_slope_(-std::numeric_limits<double>::infinity()),
      most_slope_(std::numeric_limits<double>::infinity()) {
  const double length = glm::distance(begin, end);
  if (length > 0) direction_ = (end - begin) / length;
  keep_to(end);
}

double StraightWay::slope(Vec2 point) const {
  const Vec2 way = point - begin_;
  return (direction_.x * way.y - direction_.y * way.x) / along(point);
}

void StraightWay::keep_to(Vec2 point) {
  reach_ = along(point);
  const double margin = tolerance_ / reach_;
  least_slope_ = std::max(least_slope_, slope(point) - margin);
  most_slope_ = std::min(most_slope_, slope(point) + margin);
}

bool StraightWay::go_on_to(Vec2 end) {
  if (!(along(end) > reach_)) return false;
  if (!(slope(end) >= least_slope_ && slope(end) <= most_slope_)) return false;
  keep_to(end);
  return true;
}

}  // namespace spoctree
