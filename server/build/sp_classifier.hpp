// The rules that make a cell a node of the SP-Octree (Cano, Torres, Velasco, WSCG 2003, section 2).
#pragma once

#include <cstdint>
#include <vector>

#include "server/build/cell.hpp"
#include "server/build/corner_set.hpp"
#include "server/build/expression.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

struct SpRules {
  /// A cell with at most this many remaining planes becomes a VERTEX leaf even if they share no
  /// vertex. 0: the paper's rule alone.
  std::uint32_t leaf_planes = 0;
  /// A cell at this depth becomes a VERTEX leaf whatever it holds.
  std::uint32_t max_depth = kMaxDepth;
};

/// Classifies cells one after the other, top down. Planes taken by an ancestor are "resolved":
/// `push` and `pop` bracket the visit of a GREY node's children.
class SpClassifier {
 public:
  SpClassifier(const Solid& solid, const Incidence& incidence, const SolidQueries& queries,
               const SpRules& rules);

  /// Decides on a cell whose corner states are propagated (corner_states.hpp); unknown corners are
  /// looked up in the solid. Exact; O(fragments * planes) at worst, see CornerSet.
  void classify(Cell& cell, Decision& decision);

  void push(const std::vector<std::uint32_t>& planes);
  void pop(const std::vector<std::uint32_t>& planes);

 private:
  void classify_homogeneous(Cell& cell, Decision& decision);
  void collect(const Cell& cell);
  bool is_convex();
  bool is_concave();
  bool shares_a_vertex() const;
  std::uint32_t triangle_near_centre(const Cell& cell) const;
  CornerState state_of(Cell& cell, unsigned octant) const;
  bool is_hull_plane(Cell& cell, std::uint32_t plane);
  bool no_remaining_corner_on_side(int sign);

  const Solid& solid_;
  const SolidQueries& queries_;
  const SpRules rules_;
  const CornerSides sides_;
  ExpressionBuilder expressions_;
  std::vector<std::uint8_t> resolved_;  ///< per plane: taken by an ancestor

  // Of the cell at hand.
  std::vector<Fragment> remaining_;
  std::vector<std::uint32_t> planes_;  ///< of the remaining fragments, each once
  std::vector<std::uint32_t> facets_;
  CornerSet remaining_corners_;
  CornerSet resolved_corners_;
  std::uint32_t stamp_ = 0;
  std::vector<std::uint32_t> plane_stamp_;
  std::vector<std::uint32_t> facet_stamp_;
  std::vector<std::uint32_t> vertex_stamp_;
};

}  // namespace spoctree
