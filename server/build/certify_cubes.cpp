#include "server/build/certify_cubes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>
#include <vector>

#include "common/base/parallel.hpp"
#include "common/tree/cube_measures.hpp"
#include "common/tree/pieces.hpp"
#include "server/build/certify.hpp"
#include "server/solid/triangle_distance.hpp"

namespace spoctree {

namespace {

/// Distances are computed to better than this; it is added to every bound (universe units).
constexpr double kDistanceRounding = 1e-12;

/// Boxes opened for one level at most: what is in question then stays in the bound.
constexpr std::size_t kMostSteps = 20'000;

/// A closed axis-parallel cube.
struct Cube {
  Vec3 centre{0.0};
  double half = 0;

  Vec3 corner(unsigned octant) const {
    return centre + half * Vec3{(octant & 1) ? 1.0 : -1.0, (octant & 2) ? 1.0 : -1.0,
                                (octant & 4) ? 1.0 : -1.0};
  }
  Cube child(unsigned octant) const { return {0.5 * (centre + corner(octant)), 0.5 * half}; }
  double radius() const { return std::sqrt(3.0) * half; }
  double distance(Vec3 point) const {
    return glm::length(glm::max(glm::abs(point - centre) - half, Vec3{0.0}));
  }
};

/// A cube that the solid's boundary passes through, with a bound of how far its points that are
/// not in the solid are from it.
struct MixedCube {
  double bound = 0;
  Cube cube;
  bool operator<(const MixedCube& other) const { return bound < other.bound; }
};

/// The cells of a tree whose content is not uniform: per level, GREY nodes and partial leaves.
struct MixedCells {
  struct Cell {
    Cube cube;
    std::uint32_t witness;
  };
  std::vector<std::vector<Cell>> grey, black, white;
};

MixedCells mixed_cells(const BuiltOctree& built) {
  const Octree& tree = built.tree;
  const std::size_t levels = tree.levels.size();
  MixedCells cells;
  for (auto* lists : {&cells.grey, &cells.black, &cells.white}) lists->resize(levels);
  std::vector<Cube> cubes{{Vec3{0.0}, tree.universe.half_side}};
  for (std::size_t k = 0; k < levels; ++k) {
    const Level& level = tree.levels[k];
    std::vector<Cube> below;
    below.reserve(std::size_t{8} * level.grey_count);
    for (const PartialCell& cell : built.partial_cells[k]) {
      auto& list = level.kinds[cell.node] == NodeKind::Black ? cells.black : cells.white;
      list[k].push_back({cubes[cell.node], cell.witness});
    }
    for (std::uint32_t node = 0; node < level.size(); ++node) {
      if (level.kinds[node] != NodeKind::Grey) continue;
      cells.grey[k].push_back({cubes[node], built.witnesses[k][level.first_child[node] / 8]});
      for (unsigned octant = 0; octant < 8; ++octant) below.push_back(cubes[node].child(octant));
    }
    cubes = std::move(below);
  }
  return cells;
}

/// What looking at a part of a cube told.
struct Look {
  double bound = 0;     ///< of the points in question that are in the part; 0 if there are none
  double attained = 0;  ///< by a point in question
};

/// The largest of some distance, over those points of some cubes that are in question: best first.
class FarthestInCubes {
 public:
  virtual ~FarthestInCubes() = default;

  void add(double bound, const Cube& cube) { cubes_.push_back({bound, cube}); }

  /// An upper bound, within kErrorBoundRatio of what is attained unless the limit of work was
  /// reached; 0 without cubes.
  double run() {
    if (cubes_.empty()) return 0;
    std::make_heap(cubes_.begin(), cubes_.end());
    for (std::size_t steps = 0; steps < kMostSteps && is_in_question(); ++steps) {
      std::pop_heap(cubes_.begin(), cubes_.end());
      const MixedCube mixed = cubes_.back();
      cubes_.pop_back();
      for (unsigned octant = 0; octant < 8; ++octant) {
        const Cube part = mixed.cube.child(octant);
        const Look found = look(part, part.corner(octant));
        attained_ = std::max(attained_, found.attained);
        const double bound = std::min(mixed.bound, found.bound);
        if (bound <= kErrorBoundRatio * attained_) continue;
        cubes_.push_back({bound, part});
        std::push_heap(cubes_.begin(), cubes_.end());
      }
    }
    const double open = cubes_.empty() ? 0.0 : cubes_.front().bound;
    return std::max(kErrorBoundRatio * attained_, open) + kDistanceRounding;
  }

 protected:
  /// `corner` is one of the part's, and a corner of the cube that it is a part of: often the
  /// farthest point is one.
  virtual Look look(const Cube& part, Vec3 corner) const = 0;

 private:
  bool is_in_question() const {
    return !cubes_.empty() && cubes_.front().bound > kErrorBoundRatio * attained_;
  }

  std::vector<MixedCube> cubes_;  ///< a heap
  double attained_ = 0;
};

/// How far points outside the solid are from it.
class BeyondTheSolid : public FarthestInCubes {
 public:
  BeyondTheSolid(const Solid& solid, const SolidQueries& queries)
      : solid_(solid), queries_(queries) {}

  void add(const MixedCells::Cell& cell) {
    const SolidTriangle& t = solid_.triangles[cell.witness];
    const MeasuredTriangle triangle(solid_.vertices[t.vertex[0]], solid_.vertices[t.vertex[1]],
                                    solid_.vertices[t.vertex[2]]);
    // The distance from a convex set is convex: it is largest in a corner.
    double squared = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
      squared = std::max(squared, triangle.squared_distance(cell.cube.corner(octant)));
    }
    FarthestInCubes::add(std::sqrt(squared), cell.cube);
  }

 protected:
  Look look(const Cube& part, Vec3 corner) const override {
    const double distance = queries_.distance(part.centre);
    const double at_corner = distance_of_outside(corner);
    // From material, the way to what is beyond it leads through the boundary.
    if (queries_.side_of(part.centre) == SolidQueries::Side::In) {
      return {part.radius() - distance, at_corner};
    }
    return {part.radius() + distance, std::max(distance, at_corner)};
  }

 private:
  double distance_of_outside(Vec3 point) const {
    return queries_.side_of(point) == SolidQueries::Side::In ? 0 : queries_.distance(point);
  }

  const Solid& solid_;
  const SolidQueries& queries_;
};

/// The BLACK leaf nearest to a point. REQUIRES: there is one.
Cube nearest_black_leaf(const Octree& tree, Vec3 point) {
  struct Open {
    double distance;
    std::uint32_t level;
    std::uint32_t node;
    Cube cube;
    bool operator<(const Open& other) const { return distance > other.distance; }
  };
  std::priority_queue<Open> open;
  const Cube root{Vec3{0.0}, tree.universe.half_side};
  open.push({root.distance(point), 0, 0, root});
  for (;;) {
    const Open nearest = open.top();
    open.pop();
    const Level& level = tree.levels[nearest.level];
    if (level.kinds[nearest.node] == NodeKind::Black) return nearest.cube;
    const std::uint32_t first_child = level.first_child[nearest.node];
    for (unsigned octant = 0; octant < 8; ++octant) {
      const NodeKind kind = tree.levels[nearest.level + 1].kinds[first_child + octant];
      if (kind == NodeKind::White) continue;
      const Cube child = nearest.cube.child(octant);
      open.push({child.distance(point), nearest.level + 1, first_child + octant, child});
    }
  }
}

/// How far points of the solid are from the BLACK leaves.
class MissingInTheTree : public FarthestInCubes {
 public:
  MissingInTheTree(const Octree& tree, const SolidQueries& queries)
      : tree_(tree), queries_(queries) {}

  void add(const MixedCells::Cell& cell) {
    FarthestInCubes::add(farthest_corner(cell.cube, nearest_black_leaf(tree_, cell.cube.centre)),
                         cell.cube);
  }

 protected:
  Look look(const Cube& part, Vec3 corner) const override {
    const bool centre_is_outside = queries_.side_of(part.centre) == SolidQueries::Side::Out;
    if (centre_is_outside && queries_.distance(part.centre) > part.radius() + kDistanceRounding) {
      return {};
    }
    const Cube black = nearest_black_leaf(tree_, part.centre);
    Look found;
    found.bound = farthest_corner(part, black);
    if (!centre_is_outside) found.attained = black.distance(part.centre);
    if (queries_.side_of(corner) != SolidQueries::Side::Out) {
      found.attained = std::max(found.attained, nearest_black_leaf(tree_, corner).distance(corner));
    }
    return found;
  }

 private:
  static double farthest_corner(const Cube& from, const Cube& to) {
    double farthest = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
      farthest = std::max(farthest, to.distance(from.corner(octant)));
    }
    return farthest;
  }

  const Octree& tree_;
  const SolidQueries& queries_;
};

}  // namespace

void certify_cubes(BuiltOctree& built, const Solid& solid, const SolidQueries& queries,
                   const ProgressReport& report) {
  ProgressMeter progress(report);
  progress.add(0);
  measure_cubes(built.tree);
  std::vector<Level>& levels = built.tree.levels;
  const MixedCells cells = mixed_cells(built);
  std::vector<double> beyond(levels.size(), 0.0);   // of T_k from the solid
  std::vector<double> missing(levels.size(), 0.0);  // of the solid from the last T
  parallel_for(levels.size(), [&](std::size_t k) {
    BeyondTheSolid outside(solid, queries);
    for (const auto& cell : cells.grey[k]) outside.add(cell);
    for (std::size_t j = 0; j <= k; ++j) {
      for (const auto& cell : cells.black[j]) outside.add(cell);
    }
    beyond[k] = outside.run();
    MissingInTheTree inside(built.tree, queries);
    for (const auto& cell : cells.white[k]) inside.add(cell);
    missing[k] = inside.run();
    progress.add(1.0 / static_cast<double>(levels.size()));
  });
  const double unit = built.tree.universe.scale();
  double least_beyond = std::numeric_limits<double>::infinity();
  double most_missing = 0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    // T_k lies in T_k-1: what bounds the one bounds the other, whichever was found more tightly.
    least_beyond = std::min(least_beyond, beyond[k]);
    most_missing = std::max(most_missing, missing[k]);
    levels[k].statement.error_bound = std::max(least_beyond, most_missing) * unit;
  }
}

}  // namespace spoctree
