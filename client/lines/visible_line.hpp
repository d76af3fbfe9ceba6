// What a drawing is made of.
#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/plane.hpp"

namespace spoctree {

enum class LineKind : std::uint8_t {
  Crease,     ///< all faces beside it face the viewer, or none does
  Silhouette  ///< one faces the viewer, another does not: an outline of what lies nearby
};

/// A straight line of a drawing, in universe coordinates.
struct VisibleLine {
  Vec3 a{0.0};
  Vec3 b{0.0};
  LineKind kind = LineKind::Crease;
  bool hidden = false;  ///< behind material: only there if LineOptions ask for hidden lines
  /// Two of the faces beside it (beside the longest of the creases that were joined).
  PlaneRef planes[2];
};

using VisibleLines = std::vector<VisibleLine>;

}  // namespace spoctree
