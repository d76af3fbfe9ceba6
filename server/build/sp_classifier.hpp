// The rules that make a cell a node of the SP-Octree (Cano, Torres, Velasco, WSCG 2003, section 2).
#pragma once

#include <cstdint>
#include <vector>

#include "server/build/classifier.hpp"
#include "server/build/corner_set.hpp"
#include "server/build/expression.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

/// Planes taken by an ancestor are "resolved": they need no further node.
class SpClassifier : public Classifier {
 public:
  SpClassifier(const Solid& solid, const Incidence& incidence, const SolidQueries& queries,
               const SpRules& rules);

  /// Decides on a cell whose corner states are propagated (corner_states.hpp); unknown corners are
  /// looked up in the solid. Exact; O(fragments * planes) at worst, see CornerSet.
  void classify(Cell& cell, Decision& decision) override;

  void push(const std::vector<std::uint32_t>& planes) override;
  void pop(const std::vector<std::uint32_t>& planes) override;

 private:
  void collect(const Cell& cell);
  bool is_convex();
  bool is_concave();
  bool shares_a_vertex() const;
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
