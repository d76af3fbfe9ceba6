#include "server/solid/split_dented_triangle.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <glm/geometric.hpp>

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = glm::dvec3;

double height_over(Point p, Point a, Point b) {
  const double length = glm::distance(a, b);
  return length > 0 ? glm::length(glm::cross(p - a, b - a)) / length : glm::distance(p, a);
}

double thickness(Point a, Point b, Point c) {
  const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  return longest > 0 ? glm::length(glm::cross(b - a, c - a)) / (longest * longest) : 0;
}

bool is_simple(std::span<const std::uint32_t> polygon, std::span<const glm::dvec3> points) {
  glm::dvec3 normal{0.0};
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    normal += glm::cross(points[polygon[i]] - points[polygon[0]],
                         points[polygon[i + 1]] - points[polygon[0]]);
  }
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
  }
  std::vector<Kernel::Point_2> seen;
  for (const std::uint32_t corner : polygon) {
    seen.emplace_back(points[corner][(axis + 1) % 3], points[corner][(axis + 2) % 3]);
  }
  return CGAL::is_simple_2(seen.begin(), seen.end(), Kernel());
}

// Places in the polygon of the corners that the triangle had; empty if there are others as well.
std::vector<std::size_t> find_triangle(std::span<const std::uint32_t> polygon,
                                       std::span<const glm::dvec3> points, double tolerance) {
  std::vector<std::size_t> left(polygon.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  const auto at = [&](std::size_t i) { return points[polygon[left[i % left.size()]]]; };
  while (left.size() > 3) {
    std::size_t flattest = 0;
    double least = -1;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const double height = height_over(at(i), at(i + left.size() - 1), at(i + 1));
      if (least < 0 || height < least) {
        least = height;
        flattest = i;
      }
    }
    if (least > tolerance) return {};
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(flattest));
  }
  return left;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> split_dented_triangle(
    std::span<const std::uint32_t> polygon, std::span<const glm::dvec3> points, double tolerance) {
  if (polygon.size() < 4 || polygon.size() > kMostDents || is_simple(polygon, points)) return {};
  const std::vector<std::size_t> corners = find_triangle(polygon, points, tolerance);
  if (corners.empty()) return {};

  struct Corner {
    std::uint32_t point;
    unsigned sides;  // that it lies in, a bit each
  };
  std::vector<Corner> rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    // Side k runs from corner k to the next; what comes before the first is in the last.
    const auto after = std::upper_bound(corners.begin(), corners.end(), i) - corners.begin();
    const auto side = static_cast<unsigned>((after + 2) % 3);
    const bool is_corner = corners[side] == i;
    rest.push_back({polygon[i], 1U << side | (is_corner ? 1U << (side + 2) % 3 : 0)});
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto off_side = [&](unsigned side) {
    return std::count_if(rest.begin(), rest.end(),
                         [&](const Corner& corner) { return (corner.sides >> side & 1U) == 0; });
  };
  while (rest.size() >= 3) {
    std::ptrdiff_t off[3];
    for (unsigned side = 0; side < 3; ++side) off[side] = off_side(side);
    std::size_t best = rest.size();
    double thickest = -1;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const Corner& before = rest[(i + rest.size() - 1) % rest.size()];
      const Corner& after = rest[(i + 1) % rest.size()];
      if ((before.sides & rest[i].sides & after.sides) != 0) continue;
      // What is left must not lie in one side.
      bool leaves_something = true;
      for (unsigned side = 0; side < 3; ++side) {
        if ((rest[i].sides >> side & 1U) == 0 && off[side] < 2) leaves_something = false;
      }
      if (rest.size() > 3 && !leaves_something) continue;
      const double here =
          thickness(points[before.point], points[rest[i].point], points[after.point]);
      if (here > thickest) {
        thickest = here;
        best = i;
      }
    }
    if (best == rest.size()) return {};
    triangles.push_back({rest[(best + rest.size() - 1) % rest.size()].point, rest[best].point,
                         rest[(best + 1) % rest.size()].point});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return triangles;
}

}  // namespace spoctree
