#include "client/rebuild/corners.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "client/rebuild/cell_corners.hpp"
#include "client/rebuild/polyhedron_corners.hpp"
#include "common/base/parallel.hpp"
#include "common/tree/cell_regions.hpp"
#include "common/tree/expression.hpp"
#include "common/tree/pieces.hpp"

namespace spoctree {

namespace {

/// A subtree of at most so many nodes is one task.
constexpr std::uint32_t kNodesPerTask = 512;

/// The corners of a part of the tree, inside its cube and on its walls: these may meet others.
struct Part {
  std::vector<CornerCount> inside;
  std::vector<CornerCount> on_walls;
};

/// Moves what is summed up to the part that it belongs to.
void divide(CornerSum& sum, const NodeAddress& cell, const Carriers& carriers, Part& part) {
  std::uint32_t walls[6];
  for (int axis = 0; axis < 3; ++axis) {
    walls[2 * axis] = carriers.number_of(PlaneRef::of_wall(axis, cell.lower[axis]));
    walls[2 * axis + 1] =
        carriers.number_of(PlaneRef::of_wall(axis, cell.lower[axis] + cell.size()));
  }
  const auto is_wall = [&](std::uint32_t plane) {
    return std::find(walls, walls + 6, plane) != walls + 6;
  };
  sum.flush([&](const CornerCount& corner) {
    const bool is_on_walls = std::any_of(corner.planes, corner.planes + 3, is_wall);
    (is_on_walls ? part.on_walls : part.inside).push_back(corner);
  });
}

/// Walks one part on its own.
class PartWalker {
 public:
  PartWalker(const Octree& tree, std::uint32_t last_level, const Carriers& carriers, CornerSum& sum)
      : tree_(tree),
        last_level_(last_level),
        carriers_(carriers),
        sum_(sum),
        regions_(tree),
        cell_corners_(tree, carriers),
        polyhedron_corners_(carriers, sum),
        storage_(tree.levels.size()) {}

  /// `bounds` are the ancestors' planes that may cut the root's cube; `parent_region` may be null.
  void walk(const NodeAddress& root, std::span<const std::uint32_t> bounds,
            const Polyhedron* parent_region) {
    Grid grid{};
    put(visit(root, bounds, bounds.size(), parent_region), 0, grid);
    for (std::uint32_t i = 0; i < 8; ++i) add_to_sum(grid, root, i & 1, (i >> 1) & 1, i >> 2, 1);
  }

 private:
  /// Corners where walls of the eight children of a node meet: at x + 3 y + 9 z, from 0 to 2.
  using Grid = std::array<std::int32_t, 27>;

  static void put(const CubeCorners& cube, std::uint32_t octant, Grid& grid) {
    for (std::uint32_t i = 0; i < 8; ++i) {
      const std::uint32_t x = (i & 1) + (octant & 1);
      const std::uint32_t y = ((i >> 1) & 1) + ((octant >> 1) & 1);
      const std::uint32_t z = (i >> 2) + (octant >> 2);
      grid[x + 3 * y + 9 * z] += cube[i];
    }
  }

  /// The walls of the grid are so many parts of the node's side apart: one, or two.
  void add_to_sum(const Grid& grid, const NodeAddress& node, std::uint32_t x, std::uint32_t y,
                  std::uint32_t z, std::uint32_t parts) {
    const std::int32_t count = grid[x + 3 * y + 9 * z];
    if (count == 0) return;
    const std::uint32_t step = node.size() / parts;
    const auto wall = [&](int axis, std::uint32_t i) {
      return carriers_.number_of(PlaneRef::of_wall(axis, node.lower[axis] + i * step));
    };
    sum_.add(wall(0, x), wall(1, y), wall(2, z), count);
  }

  /// Adds up what is in a subtree, but for the corners of its root's cube. The first `near_bounds`
  /// of the bounds cut the cube if any does (see CellRegions::select).
  CubeCorners visit(const NodeAddress& node, std::span<const std::uint32_t> bounds,
                    std::size_t near_bounds, const Polyhedron* parent_region) {
    const Level& level = tree_.levels[node.level];
    const NodeKind kind = level.kinds[node.index];
    if (kind == NodeKind::White) return {};
    if (kind == NodeKind::Black && bounds.empty()) return kFullCube;
    const auto planes = level.planes_of(node.index);
    if (kind != NodeKind::Grey || node.level == last_level_) {
      CubeCorners cube{};
      if (!cell_corners_.find(node, kind, planes, level.expression_of(node.index), bounds,
                              near_bounds, cube, sum_)) {
        visit_pieces(node, bounds);
      }
      return cube;
    }
    const std::uint32_t first_child = level.first_child[node.index];
    if (bounds.empty() && planes.empty()) return visit_children(node, first_child, nullptr);
    Polyhedron& region = storage_[node.level];
    if (!regions_.make(node, bounds, parent_region, region) || !regions_.clip(region, planes)) {
      return {};
    }
    return visit_children(node, first_child, &region);
  }

  CubeCorners visit_children(const NodeAddress& parent, std::uint32_t first_child,
                             const Polyhedron* region) {
    Grid grid{};
    const auto frame = regions_.open(region);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      const NodeAddress child = parent.child(first_child, octant);
      // A node is done with `bounds_` when it comes to its children.
      std::size_t near = 0;
      if (regions_.select(frame, child, bounds_, near)) {
        put(visit(child, bounds_, near, region), octant, grid);
      }
    }
    regions_.close(frame);
    CubeCorners cube{};
    for (std::uint32_t z = 0; z < 3; ++z) {
      for (std::uint32_t y = 0; y < 3; ++y) {
        for (std::uint32_t x = 0; x < 3; ++x) {
          if (x == 1 || y == 1 || z == 1) {
            add_to_sum(grid, parent, x, y, z, 2);
          } else {
            cube[x / 2 + y + 2 * z] = grid[x + 3 * y + 9 * z];
          }
        }
      }
    }
    return cube;
  }

  void visit_pieces(const NodeAddress& leaf, std::span<const std::uint32_t> bounds) {
    WalkOptions options;
    options.level = last_level_;
    walk_pieces(tree_, options, Subtree{leaf, {bounds.begin(), bounds.end()}}, polyhedron_corners_);
  }

  const Octree& tree_;
  const std::uint32_t last_level_;
  const Carriers& carriers_;
  CornerSum& sum_;
  CellRegions regions_;
  CellCorners cell_corners_;
  PolyhedronCorners polyhedron_corners_;
  std::vector<std::uint32_t> bounds_;
  std::vector<Polyhedron> storage_;  // the region of the GREY node of each level
};

class CornerFinder {
 public:
  CornerFinder(const Octree& tree, std::uint32_t level, const Carriers& carriers)
      : tree_(tree),
        last_level_(
            static_cast<std::uint32_t>(std::min<std::size_t>(level, tree.levels.size() - 1))),
        carriers_(carriers) {
    count_nodes();
  }

  Part find() const { return find({}, {}, nullptr); }

 private:
  /// A child that is left to do, with the planes that may cut it.
  struct Child {
    NodeAddress node;
    std::vector<std::uint32_t> bounds;
  };

  Part find(const NodeAddress& node, std::span<const std::uint32_t> bounds,
            const Polyhedron* parent_region) const {
    CornerSum sum;
    Part part;
    if (is_task(node)) {
      PartWalker(tree_, last_level_, carriers_, sum).walk(node, bounds, parent_region);
      divide(sum, node, carriers_, part);
      return part;
    }
    const Level& level = tree_.levels[node.level];
    Polyhedron region;
    std::vector<Child> children;
    CellRegions regions(tree_);
    if (regions.make(node, bounds, parent_region, region) &&
        regions.clip(region, level.planes_of(node.index))) {
      const auto frame = regions.open(&region);
      for (std::uint32_t octant = 0; octant < 8; ++octant) {
        Child child{node.child(level.first_child[node.index], octant), {}};
        if (regions.select(frame, child.node, child.bounds)) children.push_back(std::move(child));
      }
    }
    std::vector<Part> parts(children.size());
    parallel_for(children.size(), [&](std::size_t i) {
      parts[i] = find(children[i].node, children[i].bounds, &region);
    });
    for (Part& child : parts) {
      part.inside.insert(part.inside.end(), child.inside.begin(), child.inside.end());
      for (const CornerCount& corner : child.on_walls) sum.add_sorted(corner);
      child = {};
    }
    divide(sum, node, carriers_, part);
    return part;
  }

  /// Counts the nodes below every GREY node, from the last level up.
  void count_nodes() {
    nodes_below_.resize(last_level_);
    for (std::uint32_t k = last_level_; k-- > 0;) {
      const Level& level = tree_.levels[k];
      const Level& next = tree_.levels[k + 1];
      std::vector<std::uint32_t>& counts = nodes_below_[k];
      counts.assign(level.grey_count, 8);
      if (k + 1 == last_level_) continue;
      for (std::uint32_t child = 0; child < next.size(); ++child) {
        if (next.kinds[child] != NodeKind::Grey) continue;
        counts[child / 8] += nodes_below_[k + 1][next.first_child[child] / 8];
      }
    }
  }

  bool is_task(const NodeAddress& node) const {
    const Level& level = tree_.levels[node.level];
    if (level.kinds[node.index] != NodeKind::Grey || node.level == last_level_) return true;
    return nodes_below_[node.level][level.first_child[node.index] / 8] <= kNodesPerTask;
  }

  const Octree& tree_;
  const std::uint32_t last_level_;
  const Carriers& carriers_;
  std::vector<std::vector<std::uint32_t>> nodes_below_;  // by level and number of the GREY node
};

}  // namespace

std::vector<CornerCount> find_corners(const Octree& tree, std::uint32_t level,
                                      const Carriers& carriers) {
  Part part = CornerFinder(tree, level, carriers).find();
  part.inside.insert(part.inside.end(), part.on_walls.begin(), part.on_walls.end());
  return std::move(part.inside);
}

std::vector<std::uint8_t> find_sides(const Octree& tree, std::uint32_t level,
                                     const Carriers& carriers) {
  constexpr std::uint8_t kBoth = 3;
  std::vector<std::uint8_t> sides(carriers.count(), 0);
  for (std::uint32_t carrier = 0; carrier < carriers.count(); ++carrier) {
    if (carriers.is_wall(carrier)) sides[carrier] = kBoth;
  }
  std::vector<std::uint32_t> ends;
  for (std::size_t k = 0; k < tree.levels.size() && k <= level; ++k) {
    const Level& nodes = tree.levels[k];
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
      const auto planes = nodes.planes_of(node);
      const auto mark = [&](std::uint32_t plane, bool inside, bool outside) {
        const CarrierSide side = carriers.side_of_table(plane);
        if (inside) sides[side >> 1] |= static_cast<std::uint8_t>(1u << (side & 1));
        if (outside) sides[side >> 1] |= static_cast<std::uint8_t>(2u >> (side & 1));
      };
      if (nodes.kinds[node] != NodeKind::Vertex) {
        for (const std::uint32_t plane : planes) mark(plane, true, false);
        continue;
      }
      // A face looks outwards if there can be material inside and none outside.
      const auto expression = nodes.expression_of(node);
      find_ends(expression, ends);
      for (std::uint32_t i = 0; i < expression.size(); ++i) {
        if (expression[i] < kFirstPlaneToken) continue;
        const std::uint32_t inside = expression[i + 1];
        const std::uint32_t outside = expression[ends[i + 1]];
        mark(planes[expression[i] - kFirstPlaneToken], inside != kOutToken && outside != kInToken,
             inside != kInToken && outside != kOutToken);
      }
    }
  }
  return sides;
}

}  // namespace spoctree
