#include "server/solid/upward_ray.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 from_above(Vec3 p) { return {p.x, p.y}; }
Kernel::Point_3 to_cgal(Vec3 p) { return {p.x, p.y, p.z}; }

// Whether, seen from above, a ray from p to the right crosses the edge. p counts as shifted a bit
// to the right and, by far less, upwards.
bool is_left_of_edge(Vec3 p, Vec3 a, Vec3 b) {
  if ((a.y > p.y) == (b.y > p.y)) return false;
  if (a.y > b.y) std::swap(a, b);  // the answer must not depend on the edge's direction
  return CGAL::orientation(from_above(a), from_above(b), from_above(p)) == CGAL::LEFT_TURN;
}

}  // namespace

UpwardRay::Meets UpwardRay::meets(Vec3 a, Vec3 b, Vec3 c) const {
  const Kernel::Point_3 p = to_cgal(start_);
  const CGAL::Orientation side = CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c), p);
  if (side == CGAL::COPLANAR && Kernel::Triangle_3(to_cgal(a), to_cgal(b), to_cgal(c)).has_on(p)) {
    return Meets::StartsOn;
  }
  const bool is_over =
      is_left_of_edge(start_, a, b) ^ is_left_of_edge(start_, b, c) ^ is_left_of_edge(start_, c, a);
  if (!is_over) return Meets::Not;
  // The shifted ray's line crosses the triangle's inside, so it is not seen edge-on. If its start
  // is on the plane, but not on the triangle, the triangle cannot be crossed.
  const CGAL::Orientation turn = CGAL::orientation(from_above(a), from_above(b), from_above(c));
  const bool is_below =
      side != CGAL::COPLANAR && (side == CGAL::POSITIVE) != (turn == CGAL::LEFT_TURN);
  return is_below ? Meets::Crosses : Meets::Not;
}

}  // namespace spoctree
