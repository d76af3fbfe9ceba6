// Polyhedron and very many planes -> what lies inside of all of them, exactly.
#pragma once

#include <span>

#include "common/geometry/edge_crossing.hpp"
#include "common/geometry/polyhedron.hpp"

namespace spoctree {

/// Intersects polyhedra with many half-spaces in little more than linear time, where clipping by
/// one after the other (PolyhedronClipper) takes time quadratic in the faces that are left.
///
/// Randomised incremental construction (Clarkson and Shor, Applications of random sampling in
/// computational geometry II, 1989, section 3, for half-spaces): every plane that is still to come
/// knows one corner that it cuts off, so that a cut touches nothing but what it changes. Signs are
/// exact, and the order of the planes is shuffled always in the same way. Holds working memory: use
/// one per thread.
class HalfSpaceClipper {
 public:
  /// Replaces `polyhedron` by its intersection with the half-spaces of these planes of the table;
  /// false (and then the polyhedron is unspecified) if that has no interior. Faces stay in order,
  /// those of the planes come last, in the order of `planes`. Expected O(n log n) for n planes,
  /// after O(n v) for a polyhedron of v corners.
  bool clip(Polyhedron& polyhedron, std::span<const std::uint32_t> planes, const PlaneSet& set);

 private:
  static constexpr auto kNone = static_cast<std::uint32_t>(-1);

  /// From a corner to the next one of a face.
  struct HalfEdge {
    std::uint32_t origin;
    std::uint32_t twin;
    std::uint32_t next;
    std::uint32_t previous;
    std::uint32_t face;
  };
  struct Face {
    PlaneRef plane;
    std::uint32_t edge;  ///< any of it; kNone: the face is gone
  };
  struct Vertex {
    PolyhedronVertex point;
    std::uint32_t edge;     ///< any that leaves it; kNone: the vertex is gone
    std::uint32_t waiting;  ///< the first of the planes that know to cut it off
    // In the cut at hand:
    std::uint32_t seen_by;  ///< the face that the cut makes
    signed char side;
    double value;
  };
  /// A plane that is still to come.
  struct Waiting {
    PlaneRef plane;
    Plane coefficients;
    std::uint32_t cuts_off;  ///< a vertex outside of it; kNone: there is none, and never will be
    std::uint32_t next;      ///< of those with the same vertex
    std::uint32_t face;      ///< that it has made; kNone: none
  };

  void read(const Polyhedron& polyhedron);
  void write(Polyhedron& polyhedron) const;
  bool is_outside(const Waiting& plane, std::uint32_t vertex, const PlaneSet& set) const;
  void wait_at(std::uint32_t plane, std::uint32_t vertex);
  bool cut(std::uint32_t plane, const PlaneSet& set);
  std::size_t find_outside(const Waiting& plane, std::uint32_t face, const PlaneSet& set);
  void find_crossings(const Waiting& plane, const PlaneSet& set);
  void cut_face(std::uint32_t leaving, std::uint32_t cap);
  void close_rim(std::uint32_t cap);
  void look_for_others(std::uint32_t plane, const PlaneSet& set);
  std::uint32_t add_edge(std::uint32_t origin, std::uint32_t face);
  std::uint32_t end_of(std::uint32_t edge) const { return edges_[edges_[edge].twin].origin; }

  PlainVector<Vertex> vertices_;
  PlainVector<HalfEdge> edges_;
  PlainVector<Face> faces_;
  PlainVector<Waiting> planes_;
  PlainVector<std::uint32_t> order_;  // of planes_
  std::size_t vertex_count_ = 0;      // those that are not gone
  std::size_t first_faces_ = 0;       // of the polyhedron before any cut
  // Of the cut at hand.
  PlainVector<std::uint32_t> outside_;   // vertices
  PlainVector<std::uint32_t> leaving_;   // edges from there to the others
  PlainVector<std::uint32_t> crossing_;  // by edge, for these: the vertex on it
  PlainVector<std::uint32_t> rim_;       // edges of the new face
  PlainVector<std::uint32_t> rim_at_;    // by the vertex that they leave
};

}  // namespace spoctree
