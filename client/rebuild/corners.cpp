#include "client/rebuild/corners.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "client/rebuild/cell_corners.hpp"
#include "client/rebuild/polyhedron_corners.hpp"
#include "common/base/parallel.hpp"
#include "common/tree/cell_regions.hpp"
#include "common/tree/pieces.hpp"

namespace spoctree {

namespace {

/// A subtree of at most so many nodes is one task.
constexpr std::uint32_t kNodesPerTask = 512;

/// What is found in a part of the tree.
struct Part {
  std::vector<CornerCount> settled;
  std::vector<CornerCount> open;
  std::vector<Subtree> frontier;
  std::uint64_t cells_visited = 0;

  void append(Part&& other) {
    settled.insert(settled.end(), other.settled.begin(), other.settled.end());
    open.insert(open.end(), other.open.begin(), other.open.end());
    std::move(other.frontier.begin(), other.frontier.end(), std::back_inserter(frontier));
    cells_visited += other.cells_visited;
    other = {};
  }
};

/// Walks parts of the tree on its own.
class PartWalker {
 public:
  PartWalker(const Octree& tree, std::uint32_t last_level, const Carriers& carriers)
      : tree_(tree),
        last_level_(last_level),
        carriers_(carriers),
        regions_(tree),
        cell_corners_(tree, carriers),
        storage_(tree.levels.size()) {}

  /// `parent_region` may be null.
  void walk(const Subtree& part, const Polyhedron* parent_region) {
    add_cube(visit(part.root, part.planes, part.planes.size(), parent_region), part.root, settled_);
  }

  Part take() {
    const auto move_to = [](CornerSum& sum, std::vector<CornerCount>& corners) {
      sum.flush([&](const CornerCount& corner) { corners.push_back(corner); });
    };
    move_to(settled_, part_.settled);
    move_to(open_, part_.open);
    return std::move(part_);
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

  /// Adds a corner where walls meet, `step` apart from the lower ones of the node.
  void add_corner(std::int32_t count, const NodeAddress& node, std::uint32_t x, std::uint32_t y,
                  std::uint32_t z, std::uint32_t step, CornerSum& sum) const {
    if (count == 0) return;
    const auto wall = [&](int axis, std::uint32_t i) {
      return carriers_.number_of(PlaneRef::of_wall(axis, node.lower[axis] + i * step));
    };
    sum.add(wall(0, x), wall(1, y), wall(2, z), count);
  }

  void add_cube(const CubeCorners& cube, const NodeAddress& node, CornerSum& sum) const {
    for (std::uint32_t i = 0; i < 8; ++i) {
      add_corner(cube[i], node, i & 1, (i >> 1) & 1, i >> 2, node.size(), sum);
    }
  }

  /// Adds up what is in a subtree, but for the corners of its root's cube. The first `near_bounds`
  /// of the bounds cut the cube if any does (see CellRegions::select).
  CubeCorners visit(const NodeAddress& node, std::span<const std::uint32_t> bounds,
                    std::size_t near_bounds, const Polyhedron* parent_region) {
    const Level& level = tree_.levels[node.level];
    const NodeKind kind = level.kinds[node.index];
    if (kind != NodeKind::Grey || node.level == last_level_) ++part_.cells_visited;
    if (kind == NodeKind::White) return {};
    if (kind == NodeKind::Black && bounds.empty()) return kFullCube;
    const auto planes = level.planes_of(node.index);
    if (kind != NodeKind::Grey) return visit_cell(node, bounds, near_bounds, settled_);
    if (node.level == last_level_) {
      add_cube(visit_cell(node, bounds, near_bounds, open_), node, open_);
      part_.frontier.push_back({node, {bounds.begin(), bounds.end()}});
      return {};
    }
    const std::uint32_t first_child = level.first_child[node.index];
    if (bounds.empty() && planes.empty()) return visit_children(node, first_child, nullptr);
    Polyhedron& region = storage_[node.level];
    if (!regions_.make(node, bounds, parent_region, region) || !regions_.clip(region, planes)) {
      return {};
    }
    return visit_children(node, first_child, &region);
  }

  /// A leaf, or a GREY node of the last level, taken as what is inside all planes.
  CubeCorners visit_cell(const NodeAddress& node, std::span<const std::uint32_t> bounds,
                         std::size_t near_bounds, CornerSum& sum) {
    const Level& level = tree_.levels[node.level];
    CubeCorners cube{};
    if (!cell_corners_.find(node, level.kinds[node.index], level.planes_of(node.index),
                            level.expression_of(node.index), bounds, near_bounds, cube, sum)) {
      WalkOptions options;
      options.level = last_level_;
      PolyhedronCorners of_pieces(carriers_, sum);
      walk_pieces(tree_, options, Subtree{node, {bounds.begin(), bounds.end()}}, of_pieces);
    }
    return cube;
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
            add_corner(grid[x + 3 * y + 9 * z], parent, x, y, z, parent.size() / 2, settled_);
          } else {
            cube[x / 2 + y + 2 * z] = grid[x + 3 * y + 9 * z];
          }
        }
      }
    }
    return cube;
  }

  const Octree& tree_;
  const std::uint32_t last_level_;
  const Carriers& carriers_;
  CornerSum settled_;
  CornerSum open_;
  Part part_;
  CellRegions regions_;
  CellCorners cell_corners_;
  std::vector<std::uint32_t> bounds_;
  std::vector<Polyhedron> storage_;  // the region of the GREY node of each level
};

/// Divides parts of the tree into tasks.
class CornerFinder {
 public:
  /// The parts begin at `first_level`, or deeper.
  CornerFinder(const Octree& tree, std::uint32_t first_level, std::uint32_t last_level,
               const Carriers& carriers, const ProgressShare& progress)
      : tree_(tree), last_level_(last_level), carriers_(carriers), progress_(progress) {
    count_nodes(first_level);
    for (std::uint32_t k = first_level; k <= last_level; ++k) node_count_ += tree.levels[k].size();
  }

  /// `parent_region` is that of all the parts, or null.
  Part find(std::span<const Subtree> parts, const Polyhedron* parent_region) const {
    std::vector<std::size_t> begin;
    std::uint32_t nodes = kNodesPerTask;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::uint32_t more = nodes_of(parts[i].root);
      nodes += more;
      if (nodes <= kNodesPerTask) continue;
      begin.push_back(i);
      nodes = more;
    }
    const std::size_t tasks = begin.size();
    begin.push_back(parts.size());
    std::vector<Part> found(tasks);
    parallel_for(tasks, [&](std::size_t i) {
      const auto task = parts.subspan(begin[i], begin[i + 1] - begin[i]);
      if (nodes_of(task.front().root) > kNodesPerTask) {
        found[i] = find_below(task.front(), parent_region);
        return;
      }
      PartWalker walker(tree_, last_level_, carriers_);
      std::size_t nodes_done = 0;
      for (const Subtree& part : task) {
        walker.walk(part, parent_region);
        nodes_done += nodes_of(part.root);
      }
      found[i] = walker.take();
      progress_.add(static_cast<double>(nodes_done) / static_cast<double>(node_count_));
    });
    Part all;
    for (Part& part : found) all.append(std::move(part));
    return all;
  }

 private:
  Part find_below(const Subtree& part, const Polyhedron* parent_region) const {
    const NodeAddress& node = part.root;
    const Level& level = tree_.levels[node.level];
    CellRegions regions(tree_);
    Polyhedron region;
    if (!regions.make(node, part.planes, parent_region, region) ||
        !regions.clip(region, level.planes_of(node.index))) {
      return {};
    }
    std::vector<Subtree> children;
    const auto frame = regions.open(&region);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      Subtree child{node.child(level.first_child[node.index], octant), {}};
      if (regions.select(frame, child.root, child.planes)) children.push_back(std::move(child));
    }
    return find(children, &region);
  }

  /// Counts the nodes below every GREY node, from the last level up.
  void count_nodes(std::uint32_t first_level) {
    nodes_below_.resize(last_level_);
    for (std::uint32_t k = last_level_; k-- > first_level;) {
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

  std::uint32_t nodes_of(const NodeAddress& node) const {
    const Level& level = tree_.levels[node.level];
    if (level.kinds[node.index] != NodeKind::Grey || node.level == last_level_) return 1;
    return 1 + nodes_below_[node.level][level.first_child[node.index] / 8];
  }

  const Octree& tree_;
  const std::uint32_t last_level_;
  const Carriers& carriers_;
  const ProgressShare progress_;
  std::size_t node_count_ = 0;
  std::vector<std::vector<std::uint32_t>> nodes_below_;  // by level and number of the GREY node
};

}  // namespace

void LevelCorners::advance(const Octree& tree, std::uint32_t level, const Carriers& carriers,
                           const ProgressShare& progress) {
  if (level < level_count_) return;
  const std::uint32_t first_level = level_count_ == 0 ? 0 : level_count_ - 1;
  Part found =
      CornerFinder(tree, first_level, level, carriers, progress.part(0.9)).find(frontier_, nullptr);
  sort_corners(found.settled, carriers.table_count());
  progress.add(0.05);
  sort_corners(found.open, carriers.table_count());
  settled_ =
      settled_.empty() ? std::move(found.settled) : add_sorted_corners(settled_, found.settled);
  open_ = std::move(found.open);
  frontier_ = std::move(found.frontier);
  level_count_ = level + 1;
  cells_visited_ += found.cells_visited;
  progress.add(0.05);
}

}  // namespace spoctree
