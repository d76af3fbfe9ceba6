#include "tests/support/cell_oracle.hpp"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>

#include "tests/support/solid_mesh.hpp"

namespace spoctree {

namespace {

using Number = CGAL::Exact_rational;
using Vector = std::array<Number, 3>;

Vector exact(Vec3 v) { return {Number(v.x), Number(v.y), Number(v.z)}; }

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Along the axis, the triangle is on one side of the open box, or touches it from there.
bool separates(const Vector& axis, const std::array<Vector, 3>& triangle, const Vector& lower,
               const Number& side) {
  Number low = dot(axis, lower);
  Number high = low;
  for (const Number& component : axis) (component < 0 ? low : high) += component * side;
  if (low == high) return false;  // no axis
  const std::array<Number, 3> at = {dot(axis, triangle[0]), dot(axis, triangle[1]),
                                    dot(axis, triangle[2])};
  return *std::max_element(at.begin(), at.end()) <= low ||
         *std::min_element(at.begin(), at.end()) >= high;
}

/// Two convex sets, one of them open, are apart if and only if some axis of the difference of their
/// closures separates them: the box's, the triangle's normal, or a product of edges.
bool meets_inside(const std::array<Vec3, 3>& corners, Vec3 lower, double side) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    if (high <= lower[axis] || low >= lower[axis] + side) return false;
  }
  const std::array<Vector, 3> triangle = {exact(corners[0]), exact(corners[1]), exact(corners[2])};
  const Vector low = exact(lower);
  const Number length(side);
  const std::array<Vector, 3> edges = {minus(triangle[1], triangle[0]),
                                       minus(triangle[2], triangle[1]),
                                       minus(triangle[0], triangle[2])};
  if (separates(cross(edges[0], edges[1]), triangle, low, length)) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector unit{0, 0, 0};
    unit[axis] = 1;
    for (const Vector& edge : edges) {
      if (separates(cross(unit, edge), triangle, low, length)) return false;
    }
  }
  return true;
}

}  // namespace

CellOracle::CellOracle(const Solid& solid)
    : half_side_(solid.universe.half_side), mesh_(universe_mesh_of(solid)), judge_(mesh_) {}

CellOracle::Cell CellOracle::cell(Vec3 lower, double side) const {
  for (const auto& face : mesh_.faces) {
    const std::array<Vec3, 3> corners = {mesh_.points[face[0]], mesh_.points[face[1]],
                                         mesh_.points[face[2]]};
    if (meets_inside(corners, lower, side)) return Cell::Mixed;
  }
  return judge_.is_inside(lower + 0.5 * side) ? Cell::Full : Cell::Void;
}

std::vector<CellOracle::Cell> CellOracle::cells(int depth) const {
  const int count = 1 << depth;
  const double side = 2 * half_side_ / count;
  std::vector<Cell> cells;
  for (int z = 0; z < count; ++z) {
    for (int y = 0; y < count; ++y) {
      for (int x = 0; x < count; ++x) {
        cells.push_back(cell(Vec3(x, y, z) * side - half_side_, side));
      }
    }
  }
  return cells;
}

}  // namespace spoctree
