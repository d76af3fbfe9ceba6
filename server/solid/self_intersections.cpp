#include "server/solid/self_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <utility>

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Triangle = Kernel::Triangle_3;

// The corners of both triangles, each rotated so that what they share comes first.
struct Pair {
  std::array<Point, 3> a;
  std::array<Point, 3> b;
  int shared = 0;
};

bool is_on_one_side(const std::array<Point, 3>& plane, const Point& p, const Point& q) {
  const CGAL::Orientation at_p = CGAL::orientation(plane[0], plane[1], plane[2], p);
  return at_p != CGAL::COPLANAR && at_p == CGAL::orientation(plane[0], plane[1], plane[2], q);
}

// They share an edge. Unless they are folded flat onto each other, nothing else.
bool is_folded(const Pair& pair) {
  return CGAL::orientation(pair.a[0], pair.a[1], pair.a[2], pair.b[2]) == CGAL::COPLANAR &&
         CGAL::coplanar_orientation(pair.a[0], pair.a[1], pair.a[2], pair.b[2]) == CGAL::POSITIVE;
}

// They share a corner. What else they share would reach the far edge of one of them.
bool meet_beyond_corner(const Pair& pair) {
  const auto& [a, b, shared] = pair;
  if (is_on_one_side(a, b[1], b[2]) || is_on_one_side(b, a[1], a[2])) return false;
  return CGAL::do_intersect(Triangle(a[0], a[1], a[2]), Segment(b[1], b[2])) ||
         CGAL::do_intersect(Triangle(b[0], b[1], b[2]), Segment(a[1], a[2]));
}

bool meet_wrongly(const Pair& pair) {
  switch (pair.shared) {
    case 0:
      return CGAL::do_intersect(Triangle(pair.a[0], pair.a[1], pair.a[2]),
                                Triangle(pair.b[0], pair.b[1], pair.b[2]));
    case 1:
      return meet_beyond_corner(pair);
    case 2:
      return is_folded(pair);
    default:
      return true;  // back to back
  }
}

// The triangles with what they share in front; meet_wrongly tells about all kinds.
bool meet_wrongly(std::span<const Vec3> points, Corners a, Corners b) {
  const auto point = [&](std::uint32_t i) { return Point(points[i].x, points[i].y, points[i].z); };
  int shared = 0;
  for (int k = shared; k < 3; ++k) {
    const auto match = std::find(b.begin() + shared, b.end(), a[static_cast<std::size_t>(k)]);
    if (match == b.end()) continue;
    std::swap(a[static_cast<std::size_t>(k)], a[static_cast<std::size_t>(shared)]);
    std::iter_swap(match, b.begin() + shared);
    ++shared;
  }
  return meet_wrongly(
      {{point(a[0]), point(a[1]), point(a[2])}, {point(b[0]), point(b[1]), point(b[2])}, shared});
}

}  // namespace

SelfIntersections find_self_intersections(std::span<const Vec3> points,
                                          std::span<const Corners> triangles,
                                          const BoxTree& boxes) {
  SelfIntersections found;
  boxes.visit_overlapping_pairs([&](std::uint32_t i, std::uint32_t j) {
    if (found.count() == kMostSelfIntersections) return;
    if (!meet_wrongly(points, triangles[i], triangles[j])) return;
    found.add({std::min(i, j), std::max(i, j)});
  });
  return found;
}

std::vector<std::array<std::uint32_t, 2>> find_new_self_intersections(
    std::span<const Vec3> points, std::span<const Corners> triangles,
    std::span<const std::uint32_t> changed, const BoxTree& boxes_before) {
  std::vector<std::array<std::uint32_t, 2>> found;
  const auto judge = [&](std::uint32_t i, std::uint32_t j) {
    if (found.size() < kMostSelfIntersections && meet_wrongly(points, triangles[i], triangles[j])) {
      found.push_back({i, j});
    }
  };
  std::vector<Corners> changed_triangles;
  std::vector<std::uint8_t> is_changed(triangles.size(), 0);
  for (const std::uint32_t t : changed) {
    changed_triangles.push_back(triangles[t]);
    is_changed[t] = 1;
  }
  box_tree_of(points, changed_triangles)
      .visit_overlapping_pairs(
          [&](std::uint32_t i, std::uint32_t j) { judge(changed[i], changed[j]); });
  for (const std::uint32_t t : changed) {
    const auto& [a, b, c] = triangles[t];
    boxes_before.visit_overlapping(box_around(points[a], points[b], points[c]),
                                   [&](std::uint32_t other) {
                                     if (is_changed[other] == 0) judge(t, other);
                                   });
  }
  return found;
}

BoxTree box_tree_of(std::span<const Vec3> points, std::span<const Corners> triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Corners& t : triangles) {
    boxes.push_back(box_around(points[t[0]], points[t[1]], points[t[2]]));
  }
  return BoxTree(boxes);
}

}  // namespace spoctree
