#include "common/tree/decision_graph.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "common/geometry/tolerances.hpp"
#include "common/tree/expression.hpp"

namespace spoctree {

namespace {

/// A cell's cube: its lower walls (units of the finest cells), centre and half side.
struct Cube {
  std::uint32_t lower[3] = {0, 0, 0};
  std::uint32_t size = std::uint32_t{1} << kMaxDepth;
  Vec3 centre{0.0};
  double half = 0;
};

Cube make_cube(const std::uint32_t (&lower)[3], std::uint32_t size, double half_side) {
  Cube cube;
  cube.size = size;
  for (int axis = 0; axis < 3; ++axis) {
    cube.lower[axis] = lower[axis];
    const double low = wall_coordinate(half_side, lower[axis]);
    const double high = wall_coordinate(half_side, lower[axis] + size);
    cube.centre[axis] = 0.5 * (low + high);
    cube.half = 0.5 * (high - low);
  }
  return cube;
}

enum class Reach { Inside, Outside, Crosses };

/// Where a cube lies with respect to a plane; `Crosses` also where it comes near to it.
Reach reach_of(const Cube& cube, const Plane& plane, double near) {
  const double value = glm::dot(plane.normal, cube.centre) - plane.offset;
  const Vec3 n = plane.normal;
  // Rays ask in doubles, and stray from a cube by their rounding: stay clear of that too.
  const double reach = cube.half * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)) + near;
  if (value > reach) return Reach::Outside;
  if (value < -reach) return Reach::Inside;
  return Reach::Crosses;
}

/// True if no point of the cube is inside `other` and outside `plane`, nor near to that: who tests
/// `other` need not test `plane`. For every factor f >= 0, plane - f other <= plane wherever the
/// point is inside `other`; the left side is linear, and its largest value in the cube is smallest
/// for one of the factors for which a component of its normal vanishes.
bool is_implied(const Cube& cube, const Plane& plane, const Plane& other, double near) {
  const double value = glm::dot(plane.normal, cube.centre) - plane.offset;
  const double other_value = glm::dot(other.normal, cube.centre) - other.offset;
  for (int axis = 0; axis < 3; ++axis) {
    const double factor = plane.normal[axis] / other.normal[axis];
    if (!(factor > 0 && factor < 16)) continue;
    const Vec3 n = plane.normal - factor * other.normal;
    const double highest =
        value - factor * other_value + cube.half * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    if (highest < -near * (1 + factor)) return true;
  }
  return false;
}

class GraphMaker {
 public:
  GraphMaker(const Octree& tree, std::uint32_t level)
      : tree_(tree),
        last_level_(std::min<std::size_t>(level, tree.levels.size() - 1)),
        near_(kNearPlane * coordinate_rounding(tree.universe)),
        lists_(last_level_ + 2) {}

  DecisionGraph make() {
    weigh_subtrees();
    const std::uint32_t lower[3] = {0, 0, 0};
    graph_.root = visit(0, 0, lower);
    graph_.cells.shrink_to_fit();
    graph_.tests.shrink_to_fit();
    return std::move(graph_);
  }

 private:
  using Planes = std::vector<std::uint32_t>;

  /// Handing planes down to the children may cost this many box tests for every node and reference
  /// below. Where there are more planes, all of them are tested at the node itself.
  static constexpr std::uint64_t kTestsPerEntry = 16;
  /// Each of so many planes is compared with each.
  static constexpr std::size_t kMostCompared = 16;

  /// weights_[k][g]: nodes and references below the g-th GREY node of level k.
  void weigh_subtrees() {
    weights_.resize(last_level_);
    for (std::size_t depth = last_level_; depth-- > 0;) {
      const Level& below = tree_.levels[depth + 1];
      auto& weights = weights_[depth];
      weights.resize(tree_.levels[depth].grey_count);
      for (std::uint32_t grey = 0; grey < weights.size(); ++grey) {
        const std::uint32_t first = 8 * grey;
        weights[grey] = 8 + below.reference_begin[first + 8] - below.reference_begin[first];
        if (depth + 1 == last_level_) continue;
        for (std::uint32_t node = first; node < first + 8; ++node) {
          if (below.kinds[node] != NodeKind::Grey) continue;
          weights[grey] += weights_[depth + 1][below.first_child[node] / 8];
        }
      }
    }
  }

  const Plane& plane(std::uint32_t index) const { return tree_.planes[index]; }

  /// Adds those of `planes` that cross the cube. False if the cube is outside one of them.
  bool clip(const Cube& cube, std::span<const std::uint32_t> planes, Planes& crossing) const {
    for (const std::uint32_t index : planes) {
      const Reach reach = reach_of(cube, plane(index), near_);
      if (reach == Reach::Outside) return false;
      if (reach == Reach::Crosses) crossing.push_back(index);
    }
    if (crossing.size() <= kMostCompared) drop_implied(cube, crossing);
    return true;
  }

  /// One after the other: of planes that imply each other, one stays.
  void drop_implied(const Cube& cube, Planes& crossing) const {
    for (std::size_t i = crossing.size(); i-- > 0;) {
      const Plane& asked = plane(crossing[i]);
      const bool is_dropped =
          std::any_of(crossing.begin(), crossing.end(), [&](std::uint32_t other) {
            return other != crossing[i] && is_implied(cube, asked, plane(other), near_);
          });
      if (is_dropped) crossing.erase(crossing.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  /// lists_[depth] holds the ancestors' planes that cross the node's cube; they are tested first.
  Step visit(std::size_t depth, std::uint32_t node, const std::uint32_t (&lower)[3]) {
    const Level& level = tree_.levels[depth];
    const NodeKind kind = level.kinds[node];
    const auto planes = level.planes_of(node);
    Planes& crossing = lists_[depth];
    if (kind == NodeKind::White) return kOutStep;
    if (kind == NodeKind::Black) return behind(crossing, kInStep);
    const std::uint32_t size = std::uint32_t{1} << (kMaxDepth - static_cast<int>(depth));
    const Cube cube = make_cube(lower, size, tree_.universe.half_side);
    switch (kind) {
      case NodeKind::White:
      case NodeKind::Black:
        break;
      case NodeKind::Convex:
        return clip(cube, planes, crossing) ? behind(crossing, kInStep) : kOutStep;
      case NodeKind::Concave: {
        const auto tokens = union_of(static_cast<std::uint32_t>(planes.size()));
        return behind(crossing, read(tokens, planes, cube));
      }
      case NodeKind::Vertex:
        return behind(crossing, read(level.expression_of(node), planes, cube));
      case NodeKind::Grey:
        if (!clip(cube, planes, crossing)) return kOutStep;
        if (depth == last_level_) return behind(crossing, kUnknownStep);
        return visit_children(depth, level.first_child[node], cube);
    }
    return kOutStep;
  }

  Step visit_children(std::size_t depth, std::uint32_t first_child, const Cube& cube) {
    const Planes& crossing = lists_[depth];
    const bool are_tested_here =
        8 * crossing.size() > kTestsPerEntry * weights_[depth][first_child / 8];
    const Step made = add_cell();
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      std::uint32_t lower[3];
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        lower[axis] = cube.lower[axis] + ((octant >> axis) & 1) * (cube.size / 2);
      }
      Planes& handed_down = lists_[depth + 1];
      handed_down.clear();
      Step step = kOutStep;
      if (are_tested_here ||
          clip(make_cube(lower, cube.size / 2, tree_.universe.half_side), crossing, handed_down)) {
        step = visit(depth + 1, first_child + octant, lower);
      }
      graph_.cells[made - kFirstCell][octant] = step;
    }
    return are_tested_here ? behind(crossing, made) : made;
  }

  Step add_cell() {
    graph_.cells.emplace_back();
    return static_cast<Step>(graph_.cells.size() - 1 + kFirstCell);
  }
  Step add_test(std::uint32_t plane) {
    if (graph_.tests.size() == kTestBit) throw std::length_error("the tree is too large to query");
    graph_.tests.push_back({plane, kOutStep, kOutStep});
    return static_cast<Step>(graph_.tests.size() - 1) | kTestBit;
  }

  /// Out unless inside all of `planes`, then `step`.
  Step behind(const Planes& planes, Step step) {
    if (planes.empty() || step == kOutStep) return step;
    const auto first = static_cast<Step>(graph_.tests.size()) | kTestBit;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const Step test = add_test(planes[i]);
      graph_.tests.back().inside = i + 1 < planes.size() ? test + 1 : step;
    }
    return first;
  }

  /// An expression without the planes that do not cross the cube. Preorder: each token fills the
  /// place that is open last.
  Step read(std::span<const std::uint32_t> tokens, std::span<const std::uint32_t> planes,
            const Cube& cube) {
    // 2 test + 1 if it is the outside of that test.
    constexpr std::uint64_t kRoot = UINT64_MAX;
    constexpr std::uint64_t kNowhere = UINT64_MAX - 1;  // what no point of the cube asks for
    Step root = kOutStep;
    const auto fill = [&](std::uint64_t place, Step step) {
      if (place == kRoot) {
        root = step;
      } else if (place != kNowhere) {
        PlaneTest& test = graph_.tests[place / 2];
        (place % 2 == 0 ? test.inside : test.outside) = step;
      }
    };
    open_.assign(1, kRoot);
    for (const std::uint32_t token : tokens) {
      const std::uint64_t place = open_.back();
      open_.pop_back();
      if (token < kFirstPlaneToken) {
        fill(place, token == kInToken ? kInStep : kOutStep);
        continue;
      }
      const std::uint32_t index = planes[token - kFirstPlaneToken];
      const Reach reach = place == kNowhere ? Reach::Inside : reach_of(cube, plane(index), near_);
      if (reach == Reach::Crosses) {
        fill(place, add_test(index));
        const std::uint64_t test = graph_.tests.size() - 1;
        open_.push_back(2 * test + 1);
        open_.push_back(2 * test);
      } else {
        open_.push_back(reach == Reach::Inside ? kNowhere : place);
        open_.push_back(reach == Reach::Inside ? place : kNowhere);
      }
    }
    return root;
  }

  const Octree& tree_;
  const std::size_t last_level_;
  const double near_;  ///< cubes so near to a plane ask for its side
  std::vector<std::vector<std::uint64_t>> weights_;
  std::vector<Planes> lists_;  ///< per depth
  std::vector<std::uint64_t> open_;
  DecisionGraph graph_;
};

static_assert(kInToken == kInStep && kOutToken == kOutStep);

}  // namespace

DecisionGraph make_decision_graph(const Octree& tree, std::uint32_t level) {
  return GraphMaker(tree, level).make();
}

}  // namespace spoctree
