#include "common/geometry/edge_crossing.hpp"

#include <algorithm>
#include <cmath>

namespace spoctree {

namespace {

/// What intersection_point promises.
constexpr double kInterpolationError = 0x1p-45;

}  // namespace

/// Between two vertices at distances a and b from the plane that err by d, the parameter of the
/// crossing, a / (a - b), errs by at most d / |a - b|.
PolyhedronVertex edge_crossing(EdgeEnd from, EdgeEnd to, PlaneRef face, PlaneRef across,
                               PlaneRef plane, const PlaneSet& planes) {
  const double span = from.value - to.value;
  const Vec3 step = to.vertex->position - from.vertex->position;
  const double length = std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)});
  const double error = std::max(from.vertex->error, to.vertex->error);
  // The ends' own errors, the parameter's, and the rounding of what is below; a little more because
  // the length and the parameter are those of the ends as they are known.
  const double bound =
      1.001 * (error + length * (2 * error + kVertexValueError) / std::abs(span)) + 0x1p-50;
  if (std::abs(span) > 0x1p-30 && bound <= kInterpolationError) {
    return {from.vertex->position + step * (from.value / span), bound, {face, across, plane}};
  }
  const ApproximatePoint point = intersection_point(planes[face], planes[across], planes[plane]);
  return {point.position, point.error, {face, across, plane}};
}

}  // namespace spoctree
