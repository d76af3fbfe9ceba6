// Faces of convex polyhedra -> what two of them in one plane have in common, exactly.
#pragma once

#include <span>

#include "common/geometry/polyhedron.hpp"

namespace spoctree {

/// A convex polygon in a plane that the caller knows: its corners, each with the outward plane of
/// the edge that leaves it.
struct CellPolygon {
  struct Corner {
    PolyhedronVertex vertex;
    PlaneRef across;
  };
  PlainVector<Corner> corners;
};

/// A face of a polyhedron, in the order of its loop.
void copy_face(const Polyhedron& polyhedron, const Polyhedron::Face& face, CellPolygon& polygon);

/// Cuts polygons. Signs are exact. Holds working memory: use one per thread.
class CellPolygonClipper {
 public:
  /// Replaces a polygon in `plane` by its intersection with the half-space of `cut`; false if that
  /// has no area. O(corners).
  bool clip(CellPolygon& polygon, PlaneRef plane, PlaneRef cut, const PlaneSet& planes);

 private:
  PlainVector<signed char> side_;
  CellPolygon result_;
};

}  // namespace spoctree
