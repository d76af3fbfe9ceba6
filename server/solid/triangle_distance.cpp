#include "server/solid/triangle_distance.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "server/solid/grid_integers.hpp"

namespace spoctree {

namespace {

/// What doubles make of the side of an edge is off by less than this times the lengths of the edge
/// and of the way to the point.
constexpr double kSideRounding = 0x1p-49;

double squared_distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 edge = b - a;
  const double t = std::clamp(glm::dot(p - a, edge) / glm::dot(edge, edge), 0.0, 1.0);
  const Vec3 way = p - (a + t * edge);
  return glm::dot(way, way);
}

}  // namespace

MeasuredTriangle::MeasuredTriangle(Vec3 a, Vec3 b, Vec3 c) : corners_{a, b, c} {
  const AreaVector area =
      area_vector(to_grid_integers(a), to_grid_integers(b), to_grid_integers(c));
  normal_ = glm::normalize(Vec3{static_cast<double>(area[0]), static_cast<double>(area[1]),
                                static_cast<double>(area[2])});
}

double MeasuredTriangle::squared_distance(Vec3 p) const {
  bool is_over = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = corners_[i];
    const Vec3 b = corners_[i == 2 ? 0 : i + 1];
    const Vec3 edge = b - a;
    const Vec3 way = p - a;
    const double side = glm::dot(glm::cross(normal_, edge), way);
    const double rounding = kSideRounding * kSideRounding * glm::dot(edge, edge);
    if (side > 0 && side * side > rounding * glm::dot(way, way)) continue;
    // The nearest edge is one of those that the point lies beyond. In doubt it is beyond: a point
    // far beyond the tip of a needle may seem to be inside of both its long edges by a rounding,
    // while a point over the triangle that is so near to an edge is as far from that.
    is_over = false;
    nearest = std::min(nearest, squared_distance_to_segment(p, a, b));
  }
  if (!is_over) return nearest;
  const double height = glm::dot(normal_, p - corners_[0]);
  return height * height;
}

}  // namespace spoctree
