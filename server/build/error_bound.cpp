#include "server/build/error_bound.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <queue>

#include "server/build/certify.hpp"

namespace spoctree {

namespace {

/// Distances are computed to better than this; it is added to every bound (universe units).
constexpr double kDistanceRounding = 1e-12;

/// Distance queries spent on one level at most.
constexpr std::size_t kQueriesPerLevel = 20000;

/// A part of a region's bounding box.
struct PartBox {
  double bound;
  Vec3 centre;
  Vec3 half;
  const Polyhedron* region;
  bool operator<(const PartBox& other) const { return bound < other.bound; }
};

PartBox box_of(const GreyRegions::Candidate& candidate) {
  const auto& vertices = candidate.region.vertices;
  Vec3 lower = vertices.front().position;
  Vec3 upper = lower;
  for (const PolyhedronVertex& vertex : vertices) {
    lower = glm::min(lower, vertex.position);
    upper = glm::max(upper, vertex.position);
  }
  return {candidate.bound, 0.5 * (lower + upper), 0.5 * (upper - lower), &candidate.region};
}

/// False if the box is certainly outside the region. Says whether its centre is inside.
bool may_meet(const PartBox& box, const PlaneSet& planes, bool& centre_is_inside) {
  constexpr double kRounding = 1e-14;
  centre_is_inside = true;
  for (const Polyhedron::Face& face : box.region->faces) {
    const Plane plane = planes[face.plane];
    const double value = glm::dot(plane.normal, box.centre) - plane.offset;
    if (value - glm::dot(glm::abs(plane.normal), box.half) > kRounding) return false;
    if (value > 0) centre_is_inside = false;
  }
  return true;
}

}  // namespace

double error_bound(const GreyRegions& regions, const PlaneSet& planes,
                   const SolidQueries& queries) {
  double attained = regions.attained;
  const auto is_in_question = [&attained](double bound) {
    return bound > kErrorBoundRatio * attained;
  };
  std::priority_queue<PartBox> open;
  for (const GreyRegions::Candidate& candidate : regions.candidates) {
    if (is_in_question(candidate.bound)) open.push(box_of(candidate));
  }
  std::size_t asked = 0;
  while (!open.empty() && is_in_question(open.top().bound) && asked < kQueriesPerLevel) {
    const PartBox box = open.top();
    open.pop();
    for (unsigned octant = 0; octant < 8; ++octant) {
      PartBox part = box;
      part.half = 0.5 * box.half;
      for (int axis = 0; axis < 3; ++axis) {
        part.centre[axis] += ((octant >> axis) & 1) ? part.half[axis] : -part.half[axis];
      }
      bool centre_is_inside = false;
      if (!may_meet(part, planes, centre_is_inside)) continue;
      ++asked;
      const double radius = glm::length(part.half);
      const double distance = queries.distance(part.centre);
      if (distance > radius || (centre_is_inside && distance > attained)) {
        const bool is_in_solid = queries.side_of(part.centre) == SolidQueries::Side::In;
        if (is_in_solid && distance > radius) continue;  // all of the part is material
        if (!is_in_solid && centre_is_inside) attained = std::max(attained, distance);
      }
      part.bound = std::min(box.bound, distance + radius);
      if (is_in_question(part.bound)) open.push(part);
    }
  }
  return std::max(kErrorBoundRatio * attained, open.empty() ? 0.0 : open.top().bound) +
         kDistanceRounding;
}

}  // namespace spoctree
