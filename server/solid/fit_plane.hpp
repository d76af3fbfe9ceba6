// Triangles that lie near one plane -> that plane.
#pragma once

#include "server/solid/flat_surface.hpp"

namespace spoctree {

struct FittedPlane {
  GridPlane plane;
  double area = 0;       ///< universe units; of the triangles' projection on their mean plane
  bool is_exact = true;  ///< all triangles' planes are equal to `plane`
};

/// The plane of the largest triangle (the first of these) if its equals have half of the area: what
/// is flat already then stays where it is. Else the plane through the triangles' common centre
/// along their mean normal, both weighted by areas. Linear. REQUIRES: at least one triangle.
FittedPlane fit_plane(const FlatSurface& surface, std::span<const std::uint32_t> triangles);

}  // namespace spoctree
