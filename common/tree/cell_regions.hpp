// Cells -> their regions: cube n the ancestors' half-spaces.
//
// Most cells are cut by none or a few of the planes that bound their parent. Which ones is found in
// doubles, for certain; only these are clipped, exactly.
#pragma once

#include <span>
#include <vector>

#include "common/geometry/half_space_clipper.hpp"
#include "common/geometry/polyhedron_clipper.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

/// Finds regions on the way down a tree. Holds working memory: use one per thread.
class CellRegions {
 public:
  explicit CellRegions(const Octree& tree) : planes_(tree.plane_set()) {}

  /// A frame of planes that bound a node; frames form a stack, as nodes do on the way down.
  using Frame = std::size_t;
  /// Opens a frame with the planes of the table that `region` has faces on; none for nullptr.
  Frame open(const Polyhedron* region);
  /// Closes a frame, and those opened after it.
  void close(Frame frame) { bounds_.resize_unset(frame); }

  /// The planes of the frame opened last that may cut a cell, into `planes`: first those on which
  /// the parent's region may have faces in the cell, `near` of them; the others cut the cell only
  /// if nothing of the region is in it. False if the cell is certainly outside one of the planes.
  bool select(Frame frame, const NodeAddress& cell, std::vector<std::uint32_t>& planes,
              std::size_t& near) const;
  bool select(Frame frame, const NodeAddress& cell, std::vector<std::uint32_t>& planes) const {
    std::size_t near = 0;
    return select(frame, cell, planes, near);
  }

  /// The region of a cell that `planes` may cut; false if it has no interior. Cut from its parent's
  /// (clipped by the parent's planes), if that is given and easier.
  bool make(const NodeAddress& cell, std::span<const std::uint32_t> planes,
            const Polyhedron* parent_region, Polyhedron& region);

  /// Intersects a region with half-spaces; false if no interior is left.
  bool clip(Polyhedron& region, std::span<const std::uint32_t> planes);

  PolyhedronClipper& clipper() { return clipper_; }
  const PlaneSet& planes() const { return planes_; }

 private:
  struct Bound {
    Plane plane;
    /// What half a cube of side 2 reaches along the normal.
    double reach;
    /// A box around the face.
    Vec3 lower;
    Vec3 upper;
    std::uint32_t index;
  };

  const PlaneSet planes_;
  PolyhedronClipper clipper_;
  HalfSpaceClipper many_clipper_;
  PlainVector<Bound> bounds_;
};

}  // namespace spoctree
