#include "client/lines/square_remainder.hpp"

#include <algorithm>
#include <utility>

namespace spoctree {

namespace {

double twice_area(std::span<const Vec2> polygon) {
  double sum = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Vec2 p = polygon[k - 1] - polygon[0];
    const Vec2 q = polygon[k] - polygon[0];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

/// The part of a convex polygon where value(corner) <= 0; `value` is linear.
template <class Value>
void clip(std::span<const Vec2> polygon, const Value& value, std::vector<Vec2>& part) {
  part.clear();
  if (polygon.empty()) return;
  Vec2 from = polygon.back();
  double at_from = value(from);
  for (const Vec2 to : polygon) {
    const double at_to = value(to);
    if ((at_from < 0 && at_to > 0) || (at_from > 0 && at_to < 0)) {
      part.push_back(from + (to - from) * (at_from / (at_from - at_to)));
    }
    if (at_to <= 0) part.push_back(to);
    from = to;
    at_from = at_to;
  }
}

/// Less than this fraction of the square is nothing.
constexpr double kNothing = 1e-12;

}  // namespace

void SquareRemainder::start(Vec2 lower, double side) {
  nothing_ = 2 * kNothing * side * side;
  parts_.assign(1, {lower, lower + Vec2{side, 0}, lower + Vec2{side, side}, lower + Vec2{0, side}});
}

void SquareRemainder::take_away(std::span<const HalfPlane> polygon) {
  const std::size_t old_count = parts_.size();
  for (std::size_t i = 0; i < old_count; ++i) {
    // The parts beyond one side after the other; what is within all of them is taken away.
    within_ = parts_[i];
    for (const HalfPlane& side : polygon) {
      if (std::any_of(within_.begin(), within_.end(), [&](Vec2 p) { return side(p) > 0; })) {
        clip(within_, side, cut_);
        std::swap(within_, cut_);
      }
      if (within_.size() < 3) break;
    }
    if (twice_area(within_) <= nothing_) continue;
    std::swap(within_, parts_[i]);
    parts_[i].clear();
    for (const HalfPlane& side : polygon) {
      clip(
          within_, [&](Vec2 p) { return -side(p); }, cut_);
      if (twice_area(cut_) > nothing_) parts_.push_back(cut_);
      clip(within_, side, cut_);
      std::swap(within_, cut_);
    }
  }
  std::erase_if(parts_, [](const Polygon& part) { return part.empty(); });
}

}  // namespace spoctree
