// The boolean expression of a VERTEX node: a binary space partition over the boundary planes in a
// cell (Thibault and Naylor, Set operations on polyhedra using binary space partitioning trees,
// SIGGRAPH 1987, over the cell's clipped boundary).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "server/build/fragment.hpp"

namespace spoctree {

/// `tokens` as in octree.hpp; `planes` are the solid's planes it uses, in the order of its tokens.
struct Expression {
  std::vector<std::uint32_t> planes;
  std::vector<std::uint32_t> tokens;
};

/// Builds one expression after the other. Holds working memory: use one per thread.
class ExpressionBuilder {
 public:
  /// REQUIRES: `solid` and `incidence` outlive this.
  ExpressionBuilder(const Solid& solid, const Incidence& incidence);
  ~ExpressionBuilder();
  ExpressionBuilder(ExpressionBuilder&&) noexcept;

  /// The expression whose in-cells are the material of a cell, up to the planes of its ancestors.
  /// `boundary` is the cell's clipped boundary; `remaining` are those of its fragments (at least
  /// one) whose planes are not in an ancestor. Splits only by planes of remaining fragments. What
  /// lies closer to a plane than the planes' own rounding (2^-52, plus the flat tolerance used) is
  /// taken to lie on it: exact up to that rounding. Small cells in mind: O(fragments^2) per split.
  /// Valid until the next call.
  const Expression& build(const FragmentList& boundary, std::span<const Fragment> remaining);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace spoctree
