#include "common/geometry/polyhedron.hpp"

#include <glm/geometric.hpp>

namespace spoctree {

void Polyhedron::clear() {
  vertices.clear();
  corners.clear();
  faces.clear();
}

namespace {

/// Faces are numbered 2 * axis + (1 for the upper one), vertices by one bit per axis.
struct CubeShape {
  Polyhedron::Corner corners[24];

  CubeShape() {
    for (unsigned axis = 0; axis < 3; ++axis) {
      // With (u, v) the next axes in cyclic order, +axis is seen counter-clockwise as 00 10 11 01.
      const unsigned u = (axis + 1) % 3;
      const unsigned v = (axis + 2) % 3;
      const std::uint32_t steps[4] = {0, 1u << u, 1u << u | 1u << v, 1u << v};
      // The edge from step k to step k + 1 lies on these walls.
      const std::uint32_t across[4] = {2 * v, 2 * u + 1, 2 * v + 1, 2 * u};
      for (unsigned k = 0; k < 4; ++k) {
        corners[8 * axis + 4 + k] = {steps[k] | 1u << axis, across[k]};
        // The lower face is seen the other way round: from step r to step r - 1.
        const unsigned r = 3 - k;
        corners[8 * axis + k] = {steps[r], across[(r + 3) % 4]};
      }
    }
  }
};

}  // namespace

void make_cell(const std::uint32_t (&lower)[3], std::uint32_t size, const PlaneSet& planes,
               Polyhedron& cell) {
  static const CubeShape shape;
  PlaneRef walls[3][2];
  double at[3][2];
  for (int axis = 0; axis < 3; ++axis) {
    walls[axis][0] = PlaneRef::of_wall(axis, lower[axis]).flipped();
    walls[axis][1] = PlaneRef::of_wall(axis, lower[axis] + size);
    at[axis][0] = wall_coordinate(planes.half_side(), lower[axis]);
    at[axis][1] = wall_coordinate(planes.half_side(), lower[axis] + size);
  }
  cell.vertices.resize_unset(8);
  for (unsigned i = 0; i < 8; ++i) {
    const unsigned x = i & 1;
    const unsigned y = (i >> 1) & 1;
    const unsigned z = i >> 2;
    cell.vertices[i] = {
        Vec3{at[0][x], at[1][y], at[2][z]}, 0, {walls[0][x], walls[1][y], walls[2][z]}};
  }
  cell.corners.resize_unset(24);
  std::memcpy(cell.corners.data(), shape.corners, sizeof shape.corners);
  cell.faces.resize_unset(6);
  for (std::uint32_t face = 0; face < 6; ++face) {
    cell.faces[face] = {walls[face / 2][face % 2], 4 * face, 4};
  }
}

Polyhedron make_cell(const std::uint32_t (&lower)[3], std::uint32_t size, const PlaneSet& planes) {
  Polyhedron cell;
  make_cell(lower, size, planes, cell);
  return cell;
}

double volume(const Polyhedron& polyhedron) {
  if (polyhedron.vertices.empty()) return 0;
  const Vec3 origin = polyhedron.vertices.front().position;
  double six_volumes = 0;
  for (const Polyhedron::Face& face : polyhedron.faces) {
    const auto loop = polyhedron.loop(face);
    const Vec3 a = polyhedron.vertices[loop[0].vertex].position - origin;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      const Vec3 b = polyhedron.vertices[loop[k].vertex].position - origin;
      const Vec3 c = polyhedron.vertices[loop[k + 1].vertex].position - origin;
      six_volumes += glm::dot(a, glm::cross(b, c));
    }
  }
  return six_volumes / 6;
}

}  // namespace spoctree
