// What a drawing is made of.
#pragma once

#include <cstdint>
#include <span>
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
  /// Neither of the line's planes stands in that node itself: but in nodes above it or, where one
  /// is a cell wall, beside it. False between two walls, which stand in no node.
  bool is_inherited = false;

  bool operator==(const LineSource&) const = default;
};

/// A stretch of a line that lies between two planes and in one node.
struct LineStretch {
  double end = 1;  ///< it reaches from where the one before ends to a + end (b - a)
  LineSource source;
  PlaneRef planes[2];  ///< two of the faces beside it

  /// Of the same planes (in either order) and of the same source.
  bool goes_on_in(const LineStretch& next) const;
};

/// A straight line of a drawing, in universe coordinates.
struct VisibleLine {
  Vec3 a{0.0};
  Vec3 b{0.0};
  LineKind kind = LineKind::Crease;
  bool hidden = false;  ///< behind material: only there if LineOptions ask for hidden lines
  /// One of its faces is a cell wall, and not all of the tree is there: a step of the frontier,
  /// which later levels take away.
  bool is_step = false;
  LineSource source;   ///< of its longest stretch
  PlaneRef planes[2];  ///< of its longest stretch
  /// What it runs along from a to b, in this order; empty if that is one stretch.
  std::vector<LineStretch> stretches;
};

using VisibleLines = std::vector<VisibleLine>;

/// All stretches of a line, one at least.
std::vector<LineStretch> stretches_of(const VisibleLine& line);

/// Makes them those of the line, equal neighbours as one. REQUIRES: there are some, and the last
/// one ends at 1.
void set_stretches(VisibleLine& line, std::span<const LineStretch> stretches);

/// The part from a + begin (b - a) to a + end (b - a).
VisibleLine cut(const VisibleLine& line, double begin, double end);

/// Turns it round.
void reverse(VisibleLine& line);
VisibleLine reversed(VisibleLine line);

}  // namespace spoctree
