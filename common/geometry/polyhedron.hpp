// Convex polyhedra named by their planes, clipped exactly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

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
/// shared with the face on plane `across`. Each face's plane is that of exactly one face.
struct Polyhedron {
  struct Corner {
    std::uint32_t vertex = 0;
    PlaneRef across;
  };
  struct Face {
    PlaneRef plane;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  std::vector<PolyhedronVertex> vertices;
  std::vector<Corner> corners;
  std::vector<Face> faces;

  std::span<const Corner> loop(const Face& face) const {
    return {corners.data() + face.first, face.count};
  }
  void clear();
};

/// A cell of the octree as a polyhedron. `lower` are the wall indices of its lower walls (units of
/// the finest cells, see wall_coordinate), `size` its side in the same units.
Polyhedron make_cell(const std::uint32_t (&lower)[3], std::uint32_t size, const PlaneSet& planes);

enum class ClipResult { Unchanged, Cut, Empty };

/// Intersects polyhedra with half-spaces. Holds working memory: use one per thread.
class PolyhedronClipper {
 public:
  /// Replaces `polyhedron` by its intersection with the half-space of `plane`. Signs are exact, so
  /// the result has the combinatorial structure of the exact intersection; `Empty` (and then the
  /// polyhedron is unspecified) if the intersection has no interior. O(corners + square of
  /// the number of edges cut).
  ClipResult clip(Polyhedron& polyhedron, PlaneRef plane, const PlaneSet& planes);

  /// Which parts of a divided polyhedron have an interior: one of them at least.
  struct Parts {
    bool inside = false;
    bool outside = false;
  };
  /// Both of clip(plane) and clip(plane.flipped()), with the same results, for less than the price
  /// of two: a part that has no interior is unspecified. REQUIRES: three different polyhedra.
  Parts split(const Polyhedron& whole, PlaneRef plane, const PlaneSet& planes, Polyhedron& inside,
              Polyhedron& outside);

 private:
  /// An edge that the plane crosses, and the vertex there.
  struct Crossing {
    std::uint32_t from, to;
    PolyhedronVertex point;
    std::uint32_t vertex;  ///< its number in the part being made, or kNone
  };
  struct Rim {
    std::uint32_t from, to;
    PlaneRef inside;
  };
  static constexpr auto kNone = static_cast<std::uint32_t>(-1);

  Parts find_sides(const Polyhedron& polyhedron, PlaneRef plane, const Plane& coefficients,
                   const PlaneSet& planes);
  void make_part(const Polyhedron& polyhedron, int kept_side, PlaneRef plane,
                 const Plane& coefficients, const PlaneSet& planes, Polyhedron& part);
  std::uint32_t cross(std::uint32_t u, std::uint32_t v, PlaneRef face, PlaneRef across,
                      PlaneRef plane, const Plane& coefficients, const PlaneSet& planes,
                      Polyhedron& part);
  void close_rim(PlaneRef plane, Polyhedron& part);

  std::vector<signed char> side_;
  std::vector<Crossing> crossings_;
  std::vector<Rim> rim_;
  std::vector<std::uint32_t> renumbered_;
  Polyhedron result_;
};

/// Exact side of a polyhedron's vertex with respect to a plane.
int side_of_vertex(const PolyhedronVertex& vertex, PlaneRef plane, const PlaneSet& planes);

/// Volume in cubed units of universe coordinates. Its error is at most about the surface's area
/// times the largest error of a vertex (at most 2^-45), so it is relative to the surface, not the
/// volume: 1e-13 of the universe cube, but 1e-4 of a cell of the deepest level.
double volume(const Polyhedron& polyhedron);

}  // namespace spoctree
