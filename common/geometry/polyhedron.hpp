// Convex polyhedra named by their planes.
#pragma once

#include <cstdint>
#include <span>

#include "common/base/plain_vector.hpp"
#include "common/geometry/plane.hpp"

namespace spoctree {

/// A corner of a convex polyhedron: exactly, the point in which `planes` meet; `position` is that
/// point up to `error` per coordinate. More than three faces may meet in it.
struct PolyhedronVertex {
  Vec3 position{0.0};
  double error = 0;
  PlaneRef planes[3];
};

/// A closed convex polyhedron with non-empty interior, as faces with their outward planes. Faces
/// are loops of corners, counter-clockwise seen from outside; the edge that leaves a corner is
/// shared with the face `across`. Each face's plane is that of exactly one face.
struct Polyhedron {
  struct Corner {
    std::uint32_t vertex;
    std::uint32_t across;  ///< index in `faces`
  };
  struct Face {
    PlaneRef plane;
    std::uint32_t first;
    std::uint32_t count;
  };
  PlainVector<PolyhedronVertex> vertices;
  PlainVector<Corner> corners;
  PlainVector<Face> faces;

  std::span<const Corner> loop(const Face& face) const {
    return {corners.data() + face.first, face.count};
  }
  /// The plane on the other side of the edge that leaves a corner.
  PlaneRef plane_across(const Corner& corner) const { return faces[corner.across].plane; }
  void clear();
};

/// A cell of the octree as a polyhedron. `lower` are the wall indices of its lower walls (units of
/// the finest cells, see wall_coordinate), `size` its side in the same units.
void make_cell(const std::uint32_t (&lower)[3], std::uint32_t size, const PlaneSet& planes,
               Polyhedron& cell);
Polyhedron make_cell(const std::uint32_t (&lower)[3], std::uint32_t size, const PlaneSet& planes);

/// Exact side of a polyhedron's vertex with respect to a plane.
int side_of_vertex(const PolyhedronVertex& vertex, PlaneRef plane, const PlaneSet& planes);

/// Volume in cubed units of universe coordinates. Its error is at most about the surface's area
/// times the largest error of a vertex (at most 2^-45), so it is relative to the surface, not the
/// volume: 1e-13 of the universe cube, but 1e-4 of a cell of the deepest level.
double volume(const Polyhedron& polyhedron);

}  // namespace spoctree
