#include "server/build/build_octree.hpp"

#include <array>
#include <cmath>
#include <memory>

#include "server/build/cell_volume.hpp"
#include "server/build/corner_states.hpp"

namespace spoctree {

namespace {

class Builder {
 public:
  Builder(const Solid& solid, const SolidQueries& queries, const BuildOptions& options)
      : solid_(solid),
        queries_(queries),
        options_(options),
        incidence_(solid),
        sides_(solid, incidence_),
        classifier_(solid, incidence_, queries, options.rules) {}

  BuiltOctree build() {
    result_.tree.universe = solid_.universe;
    Cell root;
    root.boundary = whole_boundary(solid_);
    // Import makes the universe cube larger than the solid, but it may be of the same size.
    for (unsigned octant = 0; octant < 8; ++octant) {
      const auto side = queries_.side_of(root.corner_position(solid_, octant));
      root.corners[octant] =
          side == SolidQueries::Side::Out ? CornerState::Outside : CornerState::Boundary;
    }
    Decision decision;
    classifier_.classify(root, decision);
    append(root, decision);
    if (decision.kind == NodeKind::Grey) subdivide(root, decision);
    renumber_planes();
    return std::move(result_);
  }

 private:
  /// Working memory of one depth: the eight children and the halves on the way to them.
  struct Workspace {
    std::array<Cell, 8> children;
    std::array<Decision, 8> decisions;
    std::array<FragmentList, 2> by_z;
    std::array<FragmentList, 2> by_y;
  };

  Workspace& workspace(std::uint32_t depth) {
    while (workspaces_.size() <= depth) workspaces_.push_back(std::make_unique<Workspace>());
    return *workspaces_[depth];
  }

  void append(const Cell& cell, const Decision& decision) {
    auto& levels = result_.tree.levels;
    if (levels.size() <= cell.depth) {
      levels.resize(cell.depth + 1);
      result_.witnesses.resize(cell.depth + 1);
      result_.leaf_volumes.resize(cell.depth + 1, 0.0);
      result_.leaf_areas.resize(cell.depth + 1, 0.0);
      result_.grey_areas.resize(cell.depth + 1, 0.0);
    }
    levels[cell.depth].append(decision.kind, decision.planes, decision.tokens);
    if (decision.kind == NodeKind::Grey) {
      result_.witnesses[cell.depth].push_back(decision.witness);
      result_.grey_areas[cell.depth] += boundary_area(cell);
    } else {
      if (decision.kind != NodeKind::White) {
        result_.leaf_volumes[cell.depth] += material_volume(solid_, queries_, cell);
        result_.leaf_areas[cell.depth] += boundary_area(cell);
      }
      report_progress(cell.depth);
    }
    if (decision.is_depth_limited) ++result_.depth_limited_nodes;
  }

  void report_progress(std::uint32_t depth) {
    done_ += std::ldexp(1.0, -3 * static_cast<int>(depth));
    if (options_.progress && (++leaves_ % 1024 == 0 || depth == 0)) options_.progress(done_);
  }

  /// Depth first; the nodes of each level still come in breadth-first order, because all eight
  /// children are appended before the next node of the parent's level is visited.
  void subdivide(const Cell& parent, const Decision& parent_decision) {
    Workspace& work = workspace(parent.depth);
    make_children(parent, work);
    classifier_.push(parent_decision.planes);
    for (unsigned octant = 0; octant < 8; ++octant) {
      Cell& child = work.children[octant];
      propagate_corner_states(solid_, child);
      classifier_.classify(child, work.decisions[octant]);
      append(child, work.decisions[octant]);
    }
    for (unsigned octant = 0; octant < 8; ++octant) {
      if (work.decisions[octant].kind == NodeKind::Grey) {
        subdivide(work.children[octant], work.decisions[octant]);
      }
    }
    classifier_.pop(parent_decision.planes);
  }

  void make_children(const Cell& parent, Workspace& work) {
    const auto middle = [&](int axis) {
      return wall_coordinate(solid_.universe.half_side, parent.lower[axis] + parent.size() / 2);
    };
    for (unsigned octant = 0; octant < 8; ++octant) {
      Cell& child = work.children[octant];
      child.depth = parent.depth + 1;
      child.boundary.clear();
      child.corners.fill(CornerState::Unknown);
      child.corners[octant] = parent.corners[octant];
      for (unsigned axis = 0; axis < 3; ++axis) {
        child.lower[axis] = parent.lower[axis] + (((octant >> axis) & 1) ? child.size() : 0);
      }
    }
    split(parent.boundary, 2, middle(2), work.by_z[0], work.by_z[1]);
    for (unsigned z = 0; z < 2; ++z) {
      split(work.by_z[z], 1, middle(1), work.by_y[0], work.by_y[1]);
      for (unsigned y = 0; y < 2; ++y) {
        const unsigned octant = 4 * z + 2 * y;
        split(work.by_y[y], 0, middle(0), work.children[octant].boundary,
              work.children[octant + 1].boundary);
      }
    }
  }

  void split(const FragmentList& whole, int axis, double coordinate, FragmentList& lower,
             FragmentList& upper) {
    lower.clear();
    upper.clear();
    split_fragments(whole, solid_, sides_, axis, coordinate, lower, upper);
  }

  void renumber_planes() {
    constexpr auto kNone = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> number(solid_.planes.size(), kNone);
    for (Level& level : result_.tree.levels) {
      for (std::uint32_t& plane : level.references) {
        if (number[plane] == kNone) {
          number[plane] = static_cast<std::uint32_t>(result_.tree.planes.size());
          result_.tree.planes.push_back(solid_.planes[plane]);
        }
        plane = number[plane];
      }
    }
  }

  const Solid& solid_;
  const SolidQueries& queries_;
  const BuildOptions& options_;
  const Incidence incidence_;
  const CornerSides sides_;
  SpClassifier classifier_;
  std::vector<std::unique_ptr<Workspace>> workspaces_;
  BuiltOctree result_;
  double done_ = 0;
  std::size_t leaves_ = 0;
};

}  // namespace

BuiltOctree build_octree(const Solid& solid, const SolidQueries& queries,
                         const BuildOptions& options) {
  return Builder(solid, queries, options).build();
}

}  // namespace spoctree
