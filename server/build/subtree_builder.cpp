#include "server/build/subtree_builder.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "common/base/errors.hpp"
#include "server/build/cell_volume.hpp"
#include "server/build/corner_states.hpp"

namespace spoctree {

namespace {

/// Fragments split at a time: all that is between a cell and its children stays in the cache.
constexpr std::size_t kSplitTogether = 512;

/// Shares below this are collected before they are reported.
constexpr double kWorkStep = 1e-4;

}  // namespace

void NodeBudget::spend(std::uint64_t nodes) {
  const auto some = static_cast<std::int64_t>(nodes);
  if (left_.fetch_sub(some, std::memory_order_relaxed) >= some) return;
  throw BadInput("the tree would have more than " + std::to_string(nodes_) + " nodes: " + advice_);
}

std::size_t count_fragments(const std::array<Cell, 8>& cells) {
  std::size_t count = 0;
  for (const Cell& cell : cells) count += cell.boundary.fragments.size();
  return count;
}

double child_work(double parent_work, const Cell& child, std::size_t fragments_of_all_children) {
  return parent_work * static_cast<double>(child.boundary.fragments.size()) /
         static_cast<double>(fragments_of_all_children);
}

SubtreeBuilder::SubtreeBuilder(const BuildContext& context, ProgressMeter& progress)
    : context_(context),
      progress_(progress),
      sides_(context.solid, context.incidence),
      classifier_(
          make_classifier(context.solid, context.incidence, context.queries, context.rules)) {}

void SubtreeBuilder::decide(Cell& cell, double work, Decision& decision, LevelPart& part) {
  propagate_corner_states(context_.solid, cell);
  classifier_->classify(cell, decision);
  part.nodes.append(decision.kind, decision.planes, decision.tokens);
  if (decision.kind == NodeKind::Grey) {
    part.witnesses.push_back(decision.witness);
    return;
  }
  if (decision.is_depth_limited) {
    ++part.depth_limited_nodes;
    // Such a VERTEX leaf is exact all the same.
    if (decision.kind != NodeKind::Vertex) {
      part.partial_cells.push_back({part.nodes.size() - 1, decision.witness});
    }
  }
  if (decision.kind != NodeKind::White) {
    part.leaf_volume.add(material_volume(context_.solid, context_.queries, cell));
    part.leaf_area.add(boundary_area(cell));
  }
  work_done_ += work;
  if (work_done_ < kWorkStep) return;
  progress_.add(work_done_);
  work_done_ = 0;
}

void SubtreeBuilder::build_below(const Cell& cell, double work, std::vector<LevelPart>& parts) {
  build_below(cell, work, parts, 0);
}

/// The nodes of each level come in breadth-first order, because all eight children are appended
/// before the next node of the parent's level is visited.
void SubtreeBuilder::build_below(const Cell& cell, double work, std::vector<LevelPart>& parts,
                                 std::size_t depth) {
  Workspace& own = workspace(depth);
  if (parts.size() <= depth) parts.resize(depth + 1);
  split(cell, own.children);
  const std::size_t fragments = count_fragments(own.children);
  for (unsigned octant = 0; octant < 8; ++octant) {
    Cell& child = own.children[octant];
    decide(child, child_work(work, child, fragments), own.decisions[octant], parts[depth]);
  }
  for (unsigned octant = 0; octant < 8; ++octant) {
    const Cell& child = own.children[octant];
    const Decision& decision = own.decisions[octant];
    if (decision.kind != NodeKind::Grey) continue;
    enter(decision.planes);
    build_below(child, child_work(work, child, fragments), parts, depth + 1);
    leave(decision.planes);
  }
}

SubtreeBuilder::Workspace& SubtreeBuilder::workspace(std::size_t depth) {
  while (workspaces_.size() <= depth) workspaces_.push_back(std::make_unique<Workspace>());
  return *workspaces_[depth];
}

void SubtreeBuilder::split(const Cell& parent, std::array<Cell, 8>& children) {
  context_.budget.spend(children.size());
  const Solid& solid = context_.solid;
  double middle[3];
  for (int axis = 0; axis < 3; ++axis) {
    middle[axis] =
        wall_coordinate(solid.universe.half_side, parent.lower[axis] + parent.size() / 2);
  }
  for (unsigned octant = 0; octant < 8; ++octant) {
    Cell& child = children[octant];
    child.depth = parent.depth + 1;
    child.boundary.clear();
    child.corners.fill(CornerState::Unknown);
    child.corners[octant] = parent.corners[octant];
    child.planes_above = {parent.remaining_planes, parent.planes_above[0]};
    for (unsigned axis = 0; axis < 3; ++axis) {
      child.lower[axis] = parent.lower[axis] + (((octant >> axis) & 1) ? child.size() : 0);
    }
  }
  const std::span<const Fragment> all = parent.boundary.fragments;
  for (std::size_t begin = 0; begin < all.size(); begin += kSplitTogether) {
    const auto some = all.subspan(begin, std::min(kSplitTogether, all.size() - begin));
    for (FragmentList& half : by_z_) half.clear();
    split_fragments(parent.boundary, some, solid, sides_, 2, middle[2], by_z_[0], by_z_[1]);
    for (unsigned z = 0; z < 2; ++z) {
      for (FragmentList& half : by_y_) half.clear();
      split_fragments(by_z_[z], by_z_[z].fragments, solid, sides_, 1, middle[1], by_y_[0],
                      by_y_[1]);
      for (unsigned y = 0; y < 2; ++y) {
        const unsigned octant = 4 * z + 2 * y;
        split_fragments(by_y_[y], by_y_[y].fragments, solid, sides_, 0, middle[0],
                        children[octant].boundary, children[octant + 1].boundary);
      }
    }
  }
}

}  // namespace spoctree
