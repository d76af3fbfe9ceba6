// A ray through a decision graph, front to back, as a sequence of segments of known and unknown
// material. Every crossing with a plane or a wall is a function of that plane or wall alone.
//
// What is walked is the ray moved aside by a little more than rounding can tell, all rays the same
// way: so in which order planes and walls are crossed, where they meet on the ray, and on which
// side of the ray they are where it lies in them, is the same in all cells, and that of one ray.
// (As simulation of simplicity, Edelsbrunner and Muecke, ACM Trans. Graphics 9 (1), 1990, but
// coarser than the rounding of planes, which hides what meets in the model.) Only where it starts
// with respect to a plane is decided exactly, by the ray itself.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "common/geometry/predicates.hpp"
#include "common/geometry/tolerances.hpp"
#include "common/tree/query_index.hpp"

namespace spoctree {

/// With steps of this size or less along the ray, a plane's normal or an axis is at a right angle
/// to it: within the universe cube the ray does not get away from the plane by kRayError.
inline constexpr double kParallel = 0x1p-49;

/// Where rays are moved to: upwards along all axes, as a rule. Of many directions tried, that which
/// is farthest from right angles to normals of small integers (its product with those of up to 9
/// times the square of their largest component is at least 0.17): faces, and planes of edges and
/// rays, tend to have such.
inline constexpr Vec3 kAside{0.22010491587569736, 0.89117769812468128, 0.39668140411739311};

/// True if the normal is that of a wall. Such planes are what the model's faces were, not rounded.
inline bool is_across_axis(const Plane& plane) {
  const Vec3 n = plane.normal;
  return std::abs(n.x) == 1 || std::abs(n.y) == 1 || std::abs(n.z) == 1;
}

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

  /// `rounding`: coordinate_rounding(tree.universe).
  RayWalk(const Octree& tree, const DecisionGraph& graph, double rounding, const Ray& ray)
      : tree_(tree),
        graph_(graph),
        half_side_(tree.universe.half_side),
        origin_(ray.origin),
        size_(1 + largest_coordinate(ray.origin)),
        in_plane_(kRayInPlane * rounding * size_),
        near_(2 * kRayAside * rounding + in_plane_) {
    std::frexp(largest_coordinate(ray.direction), &exponent_);
    for (int axis = 0; axis < 3; ++axis) {
      const double d = std::ldexp(ray.direction[axis], -exponent_);
      if (std::abs(d) <= kParallel) continue;
      direction_[axis] = d;
      inverse_[axis] = 1 / d;
      keep_on_side_of_wall(axis, 2 * kRayAside * rounding);
    }
    moved_origin_ = origin_ + kRayAside * rounding * aside_;
    stack_.reserve(64);
  }

  Vec3 direction() const { return direction_; }
  /// A time in units of the direction given.
  double to_units_given(double time) const { return std::ldexp(time, -exponent_); }

  Crossing cross_plane(std::uint32_t index) const {
    const Plane& plane = tree_.planes[index];
    const double ahead = plane.offset - glm::dot(plane.normal, moved_origin_);
    const double slope = glm::dot(plane.normal, direction_);
    if (std::abs(ahead) <= near_) return cross_near_plane(plane, ahead, slope);
    if (std::abs(slope) <= kParallel) return {0, 0, ahead >= 0};
    return {ahead * (1 / slope), slope, ahead >= 0};
  }
  /// The same number as for a plane that lies in the wall: what is between the two is empty.
  /// REQUIRES: the direction is not at a right angle to the axis.
  double cross_wall(int axis, double wall) const {
    return (wall - moved_origin_[axis]) * inverse_[axis];
  }

  /// When the ray itself, not moved aside, makes a crossing found at `time`. Where it runs almost
  /// along the plane, that may be far from there: then `time` is kept, where the plane is as near.
  double unmoved_time(double time, Cause cause) const {
    constexpr double kLeastSlope = 0x1p-10;
    double ahead;
    double slope;
    if ((cause & kWallCause) != 0) {
      const int axis = static_cast<int>(cause & 3);
      // The cause does not say which wall.
      const double at = (moved_origin_[axis] + time * direction_[axis]) / half_side_;
      const double wall = half_side_ * (std::nearbyint((at + 1) * 0x1p29) * 0x1p-29 - 1);
      ahead = wall - origin_[axis];
      slope = direction_[axis];
    } else {
      const Plane& plane = tree_.planes[cause];
      ahead = plane.offset - glm::dot(plane.normal, origin_);
      slope = glm::dot(plane.normal, direction_);
    }
    if (std::abs(slope) < kLeastSlope) return time;
    return std::max(ahead * (1 / slope), 0.0);
  }

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
        // As in enter_cell: on a wall is above it.
        if (!(-half_side_ <= origin_[axis] && origin_[axis] < half_side_)) span.to = 0;
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

  /// Turns the step aside so that the ray starts on the same side of a wall; on a wall: beyond it.
  /// No two walls are as near to each other.
  void keep_on_side_of_wall(int axis, double near) {
    // Rounded to the finest walls, which are 2^-29 apart, by an addition.
    constexpr double kRounding = 0x1.8p23;
    const double wall = half_side_ * ((origin_[axis] / half_side_ + kRounding) - kRounding);
    const double ahead = wall - origin_[axis];
    if (std::abs(ahead) > near) return;
    if (ahead == 0 ? direction_[axis] < 0 : ahead > 0) aside_[axis] = -aside_[axis];
  }

  /// The side, -1 or 1, of a plane on which the moved ray is if the ray lies in it. Opposite for
  /// opposite planes.
  int side_of_ray_in(const Plane& plane) const {
    const Vec3& n = plane.normal;
    const double step = glm::dot(n, aside_);
    if (step != 0) return step > 0 ? 1 : -1;
    const double first = n.x != 0 ? n.x : (n.y != 0 ? n.y : n.z);
    return first > 0 ? 1 : -1;
  }

  /// `time`, or if the ray itself has that plane behind it, or ahead of it, and the moved one has
  /// not, `unmoved`.
  static double with_sign_of(double unmoved, double time) {
    return (unmoved > 0) == (time > 0) ? time : unmoved;
  }

  /// cross_plane for rays that start near the plane: in it, or on a side that is decided exactly.
  [[gnu::cold]] Crossing cross_near_plane(const Plane& plane, double moved_ahead,
                                          double slope) const {
    double ahead = plane.offset - glm::dot(plane.normal, origin_);
    if (std::abs(ahead) <= in_plane_ && std::abs(slope) <= in_plane_ && !is_across_axis(plane)) {
      return {0, 0, side_of_ray_in(plane) < 0};
    }
    if (std::abs(ahead) <= kSideError * size_) {
      const int side = side_of_any_point(plane, origin_);
      if (side == 0 && slope == 0) return {0, 0, side_of_ray_in(plane) < 0};
      if (side == 0) {
        ahead = 0;
      } else if ((ahead < 0) != (side > 0) || ahead == 0) {
        ahead = -side * kSideError;
      }
    }
    if (std::abs(slope) <= kParallel) return {0, 0, ahead >= 0};
    return {with_sign_of(ahead * (1 / slope), moved_ahead * (1 / slope)), slope, ahead >= 0};
  }

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
      bool is_upper = origin_[a] >= middle;  // in the wall: aside_ is upwards
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
  Vec3 aside_ = kAside;
  Vec3 moved_origin_{0.0};
  const double size_;
  const double in_plane_;
  const double near_;  ///< planes so near to the moved origin may be on another side of the ray's
  Vec3 direction_{0.0};
  Vec3 inverse_{0.0};
  int exponent_ = 0;
  std::vector<Part> stack_;
};

}  // namespace spoctree
