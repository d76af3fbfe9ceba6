// Polyhedron and plane -> what lies on either side, exactly.
#pragma once

#include "common/geometry/polyhedron.hpp"

namespace spoctree {

enum class ClipResult { Unchanged, Cut, Empty };

/// Intersects polyhedra with half-spaces. Signs are exact, so results have the combinatorial
/// structure of the exact intersection. O(corners) each. Holds working memory: use one per thread.
class PolyhedronClipper {
 public:
  /// Replaces `polyhedron` by its intersection with the half-space of `plane`; `Empty` (and then
  /// the polyhedron is unspecified) if the intersection has no interior.
  ClipResult clip(Polyhedron& polyhedron, PlaneRef plane, const PlaneSet& planes);

  /// The same, with the intersection in `part`, which is set if the result is `Cut` only.
  /// REQUIRES: two different polyhedra.
  ClipResult cut(const Polyhedron& whole, PlaneRef plane, const PlaneSet& planes, Polyhedron& part);

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
  /// Where the plane crosses a face's boundary from its inner side to its outer one and back, as
  /// numbers of crossings_; unset where it does not.
  struct FaceCut {
    std::uint32_t leaves;
    std::uint32_t enters;
    std::uint32_t sides;  ///< of its corners: bit 1 + side for each
  };
  /// The edge of the new face that a face gives it ends at `to`.
  struct Rim {
    std::uint32_t to;
    std::uint32_t face;
  };
  static constexpr std::uint32_t kInside = 1;
  static constexpr std::uint32_t kOutside = 4;
  static constexpr auto kNone = static_cast<std::uint32_t>(-1);

  Parts find_sides(const Polyhedron& polyhedron, PlaneRef plane, const Plane& coefficients,
                   const PlaneSet& planes);
  void find_crossings(const Polyhedron& polyhedron, PlaneRef plane, const PlaneSet& planes);
  void make_part(const Polyhedron& polyhedron, bool keeps_inside, PlaneRef plane, Polyhedron& part);

  PlainVector<signed char> side_;  // of each vertex
  PlainVector<double> value_;      // the same as a distance, approximately
  PlainVector<PolyhedronVertex> crossings_;
  PlainVector<FaceCut> cuts_;  // of each face
  // Of the part being made.
  PlainVector<std::uint32_t> new_vertex_;
  PlainVector<std::uint32_t> new_face_;
  PlainVector<Rim> rim_;  // by the vertex where the edge begins
  Polyhedron result_;
};

}  // namespace spoctree
