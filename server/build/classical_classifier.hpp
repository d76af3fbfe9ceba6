// The rules that make a cell a node of a classical octree: full, void or mixed (the course project
// "Oc-Tree Representation of Polyhedral Objects"; Veenstra and Ahuja, ACM TOG 1988, section 1).
#pragma once

#include "server/build/classifier.hpp"

namespace spoctree {

/// A cell is mixed if the solid's boundary passes through its interior: if it has a fragment that
/// does not lie in one of its walls. A face in a wall has its material in the cell (or it would be
/// the neighbour's), and a cell with such faces alone is all material. Cells that are not mixed are
/// BLACK or WHITE, mixed ones GREY or, at the depth limit, what the rules say. Planes are taken by
/// no node.
class ClassicalClassifier : public Classifier {
 public:
  /// REQUIRES: `solid` and `queries` outlive this.
  ClassicalClassifier(const Solid& solid, const SolidQueries& queries, const ClassicalRules& rules)
      : solid_(solid), queries_(queries), rules_(rules) {}

  /// Exact. O(corners of the fragments), and a query of the solid where no corner of the cell is
  /// known.
  void classify(Cell& cell, Decision& decision) override;
  void push(const std::vector<std::uint32_t>&) override {}
  void pop(const std::vector<std::uint32_t>&) override {}

 private:
  bool is_full_at_the_limit(const Cell& cell) const;

  const Solid& solid_;
  const SolidQueries& queries_;
  const ClassicalRules rules_;
};

}  // namespace spoctree
