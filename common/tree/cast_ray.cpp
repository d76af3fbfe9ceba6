// QueryIndex::first_hit: the first change between material and emptiness on a ray.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "common/tree/query_index.hpp"
#include "common/tree/ray_walk.hpp"

namespace spoctree {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

static_assert(kOutStep == 0 && kInStep == 1 && kUnknownStep == 2);

/// Listens until both material and emptiness have been met, and so a crossing for certain.
struct FirstCrossing {
  struct Start {
    double time = kInfinity;
    Cause cause = kWallCause;
  };
  Start starts[kFirstCell];  ///< by answer

  bool is_news(Step answer) const { return starts[answer].time == kInfinity; }
  bool segment(Step answer, double from, Cause cause) {
    if (is_news(answer)) starts[answer] = {from, cause};
    return is_news(kInStep) || is_news(kOutStep);
  }
  void crossing(std::uint32_t, const RayWalk::Crossing&) {}
};

/// Looks for the plane that the ray crosses nearest to a time. Distances are along the normal.
struct NearestPlane {
  double time;
  double largest_distance;
  bool found = false;
  std::uint32_t plane = 0;

  bool is_news(Step) const { return false; }
  bool segment(Step, double, Cause) { return true; }
  void crossing(std::uint32_t index, const RayWalk::Crossing& crossing) {
    if (crossing.slope == 0) return;
    const double distance = std::abs((crossing.time - time) * crossing.slope);
    if (!(distance < largest_distance)) return;
    largest_distance = distance;
    plane = index;
    found = true;
  }
};

}  // namespace

RayAnswer QueryIndex::first_hit(const Ray& ray) const {
  RayWalk walk(*tree_, graph_, rounding_, ray);
  const RayWalk::Span span = walk.in_universe();
  if (!(span.from < span.to)) return {};
  FirstCrossing met;
  auto& [out, in, unknown] = met.starts;
  if (span.from > 0) out = {0, kWallCause};  // it comes from beyond the universe
  walk.walk(span.from, span.to, span.from_cause, met);
  if (met.is_news(kOutStep)) out = {span.to, span.to_cause};

  const FirstCrossing::Start certain = in.time > out.time ? in : out;
  if (unknown.time < kInfinity) {
    RayAnswer answer{RayAnswer::Kind::Between, 0, kInfinity};
    const double first =
        walk.unmoved_time(unknown.time, unknown.cause) - walk.error_of(unknown.cause);
    // A ray that starts where nothing is known may cross the boundary at once.
    const bool starts_unknown = unknown.time <= std::min(in.time, out.time);
    if (!starts_unknown && first > 0) answer.first = walk.to_units_given(first);
    if (in.time < kInfinity) {
      answer.last = walk.to_units_given(walk.unmoved_time(certain.time, certain.cause) +
                                        walk.error_of(certain.cause));
    }
    return answer;
  }
  if (in.time == kInfinity) return {};

  Cause cause = certain.cause;
  if ((cause & kWallCause) != 0) {
    // Rounding has put a face that ends at the wall behind it, as a rule.
    const double reach = 4 * walk.error_of(cause);
    NearestPlane nearest{certain.time, 4 * kRayError * (1 + largest_coordinate(ray.origin))};
    walk.walk(certain.time - reach, certain.time + reach, cause, nearest);
    if (nearest.found) cause = nearest.plane;
  }
  Vec3 normal{0.0};
  if ((cause & kWallCause) != 0) {
    normal[static_cast<int>(cause & 3)] = 1;
  } else {
    normal = tree_->planes[cause].normal;
  }
  const bool enters = in.time > out.time;
  if ((glm::dot(normal, walk.direction()) > 0) == enters) normal = -normal;
  const double time = walk.to_units_given(walk.unmoved_time(certain.time, cause));
  return {RayAnswer::Kind::Hit, time, time, normal + 0.0};  // + 0.0: no negative zeros
}

}  // namespace spoctree
