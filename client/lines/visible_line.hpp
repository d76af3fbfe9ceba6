// What a drawing is made of.
#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/plane.hpp"
#include "common/tree/node_kind.hpp"

namespace spoctree {

enum class LineKind : std::uint8_t {
  Crease,     ///< all faces beside it face the viewer, or none does
  Silhouette  ///< one faces the viewer, another does not: an outline of what lies nearby
};

/// Where the tree has a line from: the leaf (or GREY node of the level drawn) whose material it
/// lies on, and where its planes stand.
struct LineSource {
  NodeKind kind = NodeKind::Grey;
  std::uint8_t level = 0;
  /// Both of the line's planes stand in nodes above that one.
  bool is_inherited = false;

  bool operator==(const LineSource&) const = default;
};

/// A straight line of a drawing, in universe coordinates.
struct VisibleLine {
  Vec3 a{0.0};
  Vec3 b{0.0};
  LineKind kind = LineKind::Crease;
  bool hidden = false;  ///< behind material: only there if LineOptions ask for hidden lines
  /// One of its faces is a cell wall: a step of the frontier, which later levels take away.
  bool is_step = false;
  LineSource source;  ///< of the longest part, where several were joined
  /// Two of the faces beside it (beside the longest of the creases that were joined).
  PlaneRef planes[2];
};

using VisibleLines = std::vector<VisibleLine>;

}  // namespace spoctree
