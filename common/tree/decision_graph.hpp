// A level of a tree, compiled for queries: cells that lead to their octants, and tests of one plane
// each, so that a leaf asks only for planes that really cross its cube.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/tree/octree.hpp"

namespace spoctree {

/// Where a query goes on: an answer, a cell, or a plane test. Bit 31: a test; bits 0-30 its index.
/// Without it, 0 to 2 are answers, and from kFirstCell on cells stand in order.
using Step = std::uint32_t;
inline constexpr Step kOutStep = 0;
inline constexpr Step kInStep = 1;
inline constexpr Step kUnknownStep = 2;
inline constexpr Step kFirstCell = 3;
inline constexpr Step kTestBit = Step{1} << 31;

/// Asks for the side of a plane of the table.
struct PlaneTest {
  std::uint32_t plane = 0;
  Step inside = kOutStep;
  Step outside = kOutStep;
};

/// The material of T_level. A cell's octants are the halves of the cube it stands for, the root's
/// is the universe cube; tests leave the cube as it is. Each answer is that of the point inside its
/// cube and on none of the planes asked for on the way. A plane is not asked for in cubes that lie
/// strictly on one side of it, nor together with another plane whose inside, within the cube, lies
/// strictly inside it; strictly: by more than the rounding of doubles.
struct DecisionGraph {
  Step root = kOutStep;
  std::vector<std::array<Step, 8>> cells;
  std::vector<PlaneTest> tests;

  static bool is_test(Step step) { return (step & kTestBit) != 0; }
  static bool is_answer(Step step) { return step < kFirstCell; }
  static bool is_cell(Step step) { return !is_test(step) && !is_answer(step); }
  const PlaneTest& test(Step step) const { return tests[step & ~kTestBit]; }
  const std::array<Step, 8>& cell(Step step) const { return cells[step - kFirstCell]; }
};

/// Compiles levels 0..`level` (beyond the last one: all). Linear in nodes, references and tokens as
/// a rule, times the depth at worst (planes that cross everything stay with the ancestor);
/// memory likewise. Throws std::length_error for trees of more than 2^31 references and tokens.
/// REQUIRES: a valid tree with at least one level.
DecisionGraph make_decision_graph(const Octree& tree, std::uint32_t level);

}  // namespace spoctree
