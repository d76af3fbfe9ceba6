// A ray through a decision graph, front to back, as a sequence of segments of known and unknown
// material. Every crossing with a plane or a wall is a function of that plane or wall alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "common/geometry/predicates.hpp"
#include "common/tree/query_index.hpp"

namespace spoctree {

/// With steps of this size or less along the ray, a plane's normal or an axis is at a right angle
/// to it: within the universe cube the ray does not get away from the plane by kRayError.
inline constexpr double kParallel = 0x1p-49;

/// What a segment begins at: a plane of the table, or a wall, named by its axis.
using Cause = std::uint32_t;
inline constexpr Cause kWallCause = Cause{1} << 31;

inline double largest_coordinate(Vec3 v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The ray with a direction whose largest component is in [0.5, 1) in magnitude. Times are counted
/// in steps of that direction.
class RayWalk {
 public:
  struct Crossing {
    double time = 0;
    double slope = 0;  ///< normal . direction; 0: does not cross, and then:
    bool starts_inside = true;
  };

  RayWalk(const Octree& tree, const DecisionGraph& graph, const Ray& ray)
      : tree_(tree),
        graph_(graph),
        half_side_(tree.universe.half_side),
        origin_(ray.origin),
        size_(1 + largest_coordinate(ray.origin)) {
    std::frexp(largest_coordinate(ray.direction), &exponent_);
    for (int axis = 0; axis < 3; ++axis) {
      const double d = std::ldexp(ray.direction[axis], -exponent_);
      if (std::abs(d) <= kParallel) continue;
      direction_[axis] = d;
      inverse_[axis] = 1 / d;
    }
    stack_.reserve(64);
  }

  Vec3 direction() const { return direction_; }
  /// A time in units of the direction given.
  double to_units_given(double time) const { return std::ldexp(time, -exponent_); }

  Crossing cross_plane(std::uint32_t index) const {
    const Plane& plane = tree_.planes[index];
    double ahead = plane.offset - glm::dot(plane.normal, origin_);
    // The sign decides on which side the ray starts: exactly.
    if (std::abs(ahead) <= kSideError * size_) {
      const int side = side_of_any_point(plane, origin_);
      if (side == 0) {
        ahead = 0;
      } else if ((ahead < 0) != (side > 0) || ahead == 0) {
        ahead = -side * kSideError;
      }
    }
    const double slope = glm::dot(plane.normal, direction_);
    if (std::abs(slope) <= kParallel) return {0, 0, ahead >= 0};
    return {ahead * (1 / slope), slope, ahead >= 0};
  }
  /// The same number as for a plane that lies in the wall: what is between the two is empty.
  /// REQUIRES: the direction is not at a right angle to the axis.
  double cross_wall(int axis, double wall) const { return (wall - origin_[axis]) * inverse_[axis]; }

  /// How far the time of a crossing may be off.
  double error_of(Cause cause) const {
    const double slope = (cause & kWallCause) != 0
                             ? direction_[static_cast<int>(cause & 3)]
                             : glm::dot(tree_.planes[cause].normal, direction_);
    return kRayError * size_ / std::max(std::abs(slope), kParallel);
  }

  struct Span {
    double from = 0;
    double to = 0;
    Cause from_cause = kWallCause;
    Cause to_cause = kWallCause;
  };
  /// The part of the ray in the universe cube; empty (from >= to) if there is none.
  Span in_universe() const {
    Span span{0, std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
      if (direction_[axis] == 0) {
        if (std::abs(origin_[axis]) > half_side_) span.to = 0;
        continue;
      }
      const double near_wall = direction_[axis] > 0 ? -half_side_ : half_side_;
      const double enters = cross_wall(axis, near_wall);
      const double leaves = cross_wall(axis, -near_wall);
      const Cause cause = kWallCause | static_cast<Cause>(axis);
      if (enters > span.from) span.from = enters, span.from_cause = cause;
      if (leaves < span.to) span.to = leaves, span.to_cause = cause;
    }
    return span;
  }

  /// Calls sink.segment(answer, from, to, cause of from) for the parts of the ray between `from`
  /// and `to` in order, without gaps, until it returns false; and sink.crossing(plane, crossing)
  /// for every plane asked for. REQUIRES: from < to.
  template <class Sink>
  void walk(double from, double to, Cause cause, Sink& sink) {
    stack_.clear();
    stack_.push_back({graph_.root, std::uint32_t{1} << kMaxDepth, {0, 0, 0}, cause, from, to});
    while (!stack_.empty()) {
      Part part = stack_.back();
      stack_.pop_back();
      while (!DecisionGraph::is_answer(part.step)) {
        if (DecisionGraph::is_test(part.step)) {
          pass_test(part, sink);
        } else {
          enter_cell(part, sink);
        }
      }
      if (!sink.segment(part.step, part.from, part.cause)) return;
    }
  }

 private:
  /// A part of the ray that is still to be walked.
  struct Part {
    Step step;
    std::uint32_t size;
    std::uint32_t lower[3];
    Cause cause;
    double from;
    double to;
  };

  template <class Sink>
  void pass_test(Part& part, Sink& sink) {
    const PlaneTest& test = graph_.test(part.step);
    const Crossing crossing = cross_plane(test.plane);
    sink.crossing(test.plane, crossing);
    if (crossing.slope == 0) {
      part.step = crossing.starts_inside ? test.inside : test.outside;
      return;
    }
    const Step before = crossing.slope > 0 ? test.inside : test.outside;
    const Step behind = crossing.slope > 0 ? test.outside : test.inside;
    if (crossing.time <= part.from) {
      if (crossing.time == part.from) part.cause = test.plane;
      part.step = behind;
      return;
    }
    if (crossing.time < part.to) {
      Part& rest = stack_.emplace_back(part);
      rest.step = behind;
      rest.from = crossing.time;
      rest.cause = test.plane;
      part.to = crossing.time;
    }
    part.step = before;
  }

  template <class Sink>
  void enter_cell(Part& part, const Sink& sink) {
    const auto& octants = graph_.cell(part.step);
    part.size /= 2;
    // The octant at `from`, and the middle walls that the ray crosses until `to`, in order.
    std::uint32_t octant = 0;
    struct {
      double time;
      std::uint32_t axis;
    } walls[3];
    std::size_t count = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const int a = static_cast<int>(axis);
      const double middle = wall_coordinate(half_side_, part.lower[axis] + part.size);
      bool is_upper = origin_[a] >= middle;
      if (direction_[a] != 0) {
        const double time = cross_wall(a, middle);
        is_upper = (direction_[a] > 0) == (time <= part.from);
        if (time > part.from && time < part.to) {
          std::size_t k = count++;
          for (; k > 0 && walls[k - 1].time > time; --k) walls[k] = walls[k - 1];
          walls[k] = {time, axis};
        }
      }
      if (is_upper) octant |= 1u << axis;
    }
    std::uint32_t octant_after[3];
    std::uint32_t last = octant;
    for (std::size_t k = 0; k < count; ++k) octant_after[k] = last ^= 1u << walls[k].axis;
    const auto move_to = [&](Part& moved, std::uint32_t where) {
      moved.step = octants[where];
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        moved.lower[axis] += ((where >> axis) & 1) * part.size;
      }
    };
    double to = part.to;
    for (std::size_t k = count; k-- > 0;) {
      const Step step = octants[octant_after[k]];
      if (walls[k].time < to && !(DecisionGraph::is_answer(step) && !sink.is_news(step))) {
        Part& rest = stack_.emplace_back(part);
        rest.from = walls[k].time;
        rest.to = to;
        rest.cause = kWallCause | walls[k].axis;
        move_to(rest, octant_after[k]);
      }
      to = walls[k].time;
    }
    part.to = to;
    move_to(part, octant);
  }

  const Octree& tree_;
  const DecisionGraph& graph_;
  const double half_side_;
  const Vec3 origin_;
  const double size_;
  Vec3 direction_{0.0};
  Vec3 inverse_{0.0};
  int exponent_ = 0;
  std::vector<Part> stack_;
};

}  // namespace spoctree
