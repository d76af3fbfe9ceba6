// A cell -> the nodes in it, level by level.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "common/base/progress_meter.hpp"
#include "common/tree/octree.hpp"
#include "server/build/cell.hpp"
#include "server/build/classifier.hpp"
#include "server/build/order_free_sum.hpp"
#include "server/build/partial_cell.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

/// What is known of some consecutive nodes of one level of the tree.
struct LevelPart {
  Level nodes;  ///< `first_child` counts within the next part; planes are the solid's
  std::vector<std::uint32_t> witnesses;    ///< see BuiltOctree
  std::vector<PartialCell> partial_cells;  ///< see BuiltOctree
  OrderFreeSum leaf_volume;
  OrderFreeSum leaf_area;
  std::size_t depth_limited_nodes = 0;
};

/// How many nodes a tree may still get, for all threads. Whether it is exceeded depends on the tree
/// alone, when and by which thread on chance.
class NodeBudget {
 public:
  /// `advice` says why a tree may exceed it, and what to do.
  NodeBudget(std::uint64_t nodes, const char* advice)
      : nodes_(nodes), advice_(advice), left_(static_cast<std::int64_t>(nodes)) {}
  /// Throws BadInput when there are not so many left.
  void spend(std::uint64_t nodes);

 private:
  const std::uint64_t nodes_;
  const char* const advice_;
  std::atomic<std::int64_t> left_;
};

/// What all builders of one tree share, and none changes, but for spending nodes.
struct BuildContext {
  const Solid& solid;
  const SolidQueries& queries;
  const Incidence& incidence;
  const TreeRules& rules;
  NodeBudget& budget;
};

/// Builds one subtree after the other, depth first. Not thread-safe: one for each thread.
class SubtreeBuilder {
 public:
  SubtreeBuilder(const BuildContext& context, ProgressMeter& progress);

  /// The planes of a GREY node count as resolved from `enter` to `leave`, which bracket the work on
  /// what is below it.
  void enter(const std::vector<std::uint32_t>& planes) { classifier_->push(planes); }
  void leave(const std::vector<std::uint32_t>& planes) { classifier_->pop(planes); }

  /// Decides what a cell is and appends it to `part`. `work` is the share of all work that the cell
  /// stands for: it is done if the cell becomes a leaf.
  void decide(Cell& cell, double work, Decision& decision, LevelPart& part);

  /// Appends everything below a GREY cell that was entered to `parts`, whose entries belong to the
  /// cell's children's level and those that follow.
  void build_below(const Cell& cell, double work, std::vector<LevelPart>& parts);

  /// The eight children of a cell, in octant order; nothing is decided about them. Their storage is
  /// used again. O(fragments). Throws BadInput when the tree has no nodes left for them.
  void split(const Cell& parent, std::array<Cell, 8>& children);

 private:
  /// Working memory of one depth.
  struct Workspace {
    std::array<Cell, 8> children;
    std::array<Decision, 8> decisions;
  };

  void build_below(const Cell& cell, double work, std::vector<LevelPart>& parts, std::size_t depth);
  Workspace& workspace(std::size_t depth);

  const BuildContext& context_;
  ProgressMeter& progress_;
  const CornerSides sides_;
  const std::unique_ptr<Classifier> classifier_;
  std::vector<std::unique_ptr<Workspace>> workspaces_;
  std::array<FragmentList, 2> by_z_;  ///< of the fragments that are being split
  std::array<FragmentList, 2> by_y_;
  double work_done_ = 0;  ///< and not reported yet
};

/// The share of a parent's work that a child stands for: that of its fragments.
double child_work(double parent_work, const Cell& child, std::size_t fragments_of_all_children);

/// Number of the fragments in all eight cells.
std::size_t count_fragments(const std::array<Cell, 8>& cells);

}  // namespace spoctree
