// Creases of a boundary, and how much of the space around each the viewer can look into.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/lines/camera.hpp"

namespace spoctree {

/// A face beside a crease.
struct CreaseSide {
  PlaneRef plane;             ///< its half-space is the side of the material
  bool runs_forward = false;  ///< the face, counter-clockwise seen from outside, runs from a to b
};

/// A straight edge of the boundary.
struct Crease {
  Vec3 a{0.0};
  Vec3 b{0.0};
  std::uint32_t first_side = 0;
  std::uint32_t side_count = 0;
};

struct Creases {
  std::vector<Crease> creases;
  std::vector<CreaseSide> sides;

  std::span<const CreaseSide> sides_of(const Crease& crease) const {
    return {sides.data() + crease.first_side, crease.side_count};
  }
};

/// False if the crease is hidden by its own material: on neither side, the line of sight that
/// passes beside it, infinitely near, comes to it without entering that.
bool may_be_seen(const Crease& crease, const Creases& creases, const PlaneSet& planes,
                 const Camera& camera);

/// True if some of the crease's faces face the viewer and others do not: an outline, at least of
/// what lies nearby. A face seen edge-on does not face the viewer.
bool is_silhouette(const Crease& crease, const Creases& creases, const PlaneSet& planes,
                   const Camera& camera);

/// True if no two of its faces meet at an angle (kFlatCrease).
bool is_flat(const Crease& crease, const Creases& creases, const PlaneSet& planes);

/// The largest angle between the normals of two faces of the crease, in degrees.
double crease_angle_deg(const Crease& crease, const Creases& creases, const PlaneSet& planes);

}  // namespace spoctree
