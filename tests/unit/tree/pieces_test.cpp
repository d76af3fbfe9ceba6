// The walk over convex pieces against the definition of the tree, and its order against rays.
#include "common/tree/pieces.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>

#include "tests/support/degenerate_tree.hpp"
#include "tests/support/grid_planes.hpp"
#include "tests/support/polyhedron_checks.hpp"
#include "tests/support/sample_trees.hpp"
#include "tests/support/tree_definition.hpp"

namespace spoctree {
namespace {

struct Piece {
  NodeAddress address;
  NodeKind kind;
  Polyhedron polyhedron;
  std::vector<Plane> half_spaces;
  Vec3 centroid{0.0};
};

class PieceCollector : public PieceVisitor {
 public:
  explicit PieceCollector(const Octree& tree) : planes_(tree.plane_set()) {}

  void piece(const NodeAddress& address, NodeKind kind, std::uint32_t,
             const Polyhedron& polyhedron) override {
    Piece piece{address, kind, polyhedron, {}, Vec3{0.0}};
    for (const Polyhedron::Face& face : polyhedron.faces) {
      piece.half_spaces.push_back(planes_[face.plane]);
    }
    for (const PolyhedronVertex& vertex : polyhedron.vertices) piece.centroid += vertex.position;
    piece.centroid /= static_cast<double>(polyhedron.vertices.size());
    pieces.push_back(std::move(piece));
  }

  std::vector<Piece> pieces;

 private:
  const PlaneSet planes_;
};

std::vector<Piece> pieces_of(const Octree& tree, const WalkOptions& options) {
  PieceCollector collector(tree);
  walk_pieces(tree, options, collector);
  return std::move(collector.pieces);
}

Octree any_tree(std::uint64_t seed) {
  if (seed % 2 == 0) return degenerate_tree(seed, 4);
  RandomTreeOptions options;
  options.levels = 3;
  options.max_nodes = 100;
  return random_tree(seed, options);
}

/// How many pieces have the point inside; -1 if it is too near to a face to say.
int count_pieces_around(const std::vector<Piece>& pieces, Vec3 point) {
  int count = 0;
  for (const Piece& piece : pieces) {
    double largest = -1;
    for (const Plane& plane : piece.half_spaces) {
      largest = std::max(largest, glm::dot(plane.normal, point) - plane.offset);
    }
    if (std::abs(largest) < 1e-13) return -1;
    count += largest < 0;
  }
  return count;
}

TEST(WalkPieces, YieldsDisjointPiecesThatMakeUpEveryLevelOfTheTree) {
  Random random(1);
  int inside = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Octree tree = any_tree(seed);
    const auto levels = static_cast<std::uint32_t>(tree.levels.size());
    std::vector<std::vector<Piece>> pieces;
    std::vector<Vec3> points;
    for (std::uint32_t level = 0; level < levels; ++level) {
      WalkOptions options;
      options.level = level;
      pieces.push_back(pieces_of(tree, options));
      for (const Piece& piece : pieces.back()) {
        if (random.chance(0.2)) points.push_back(piece.centroid);
      }
    }
    for (int k = 0; k < 40; ++k) points.push_back(random_vector(random, 1));
    for (const Vec3 point : points) {
      bool was_material = true;
      for (std::uint32_t level = 0; level < levels; ++level) {
        const int count = count_pieces_around(pieces[level], point);
        if (count < 0) continue;
        RationalPoint exact = to_rational(point);
        // A direction that no plane contains, for points that lie in a wall by chance.
        const RationalPoint direction{Rational(0.391), Rational(0.817), Rational(-0.543)};
        const TreeValue value = value_of_definition(tree, level, exact, direction);
        EXPECT_EQ(count, value.is_material ? 1 : 0);
        EXPECT_TRUE(was_material || count == 0) << "a level outside the one above";
        was_material = count == 1;
        inside += count;
      }
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(WalkPieces, YieldsSoundPolyhedraOfTheRightKindsInsideTheirCells) {
  for (std::uint64_t seed = 0; seed < 14; ++seed) {
    const Octree tree = any_tree(seed);
    const PlaneSet planes = tree.plane_set();
    for (std::uint32_t level = 0; level < tree.levels.size(); ++level) {
      WalkOptions options;
      options.level = level;
      for (const Piece& piece : pieces_of(tree, options)) {
        ASSERT_EQ(structure_error(piece.polyhedron, planes), "");
        ASSERT_LE(piece.address.level, level);
        EXPECT_EQ(piece.kind, tree.levels[piece.address.level].kinds[piece.address.index]);
        EXPECT_NE(piece.kind, NodeKind::White);
        EXPECT_TRUE(piece.kind != NodeKind::Grey || piece.address.level == level);
        for (const RationalPoint& vertex : exact_vertices(piece.polyhedron, planes)) {
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t lower = piece.address.lower[axis];
            EXPECT_GE(vertex[axis], Rational(wall_coordinate(planes.half_side(), lower)));
            EXPECT_LE(vertex[axis],
                      Rational(wall_coordinate(planes.half_side(), lower + piece.address.size())));
          }
        }
      }
    }
  }
}

TEST(WalkPieces, FillsTheVolumeExactlyWhereABlackTreeIsCut) {
  // All eight children black below planes: the pieces' exact volumes add up to T_0's.
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random random(seed);
    Octree tree;
    const std::uint32_t planes[] = {0, 1};
    for (int i = 0; i < 2; ++i) {
      tree.planes.push_back(random_degenerate_plane(random, Vec3{0.0}, 1, tree.planes));
    }
    tree.levels.resize(2);
    tree.levels[0].append(NodeKind::Grey, planes);
    for (int i = 0; i < 8; ++i) tree.levels[1].append(NodeKind::Black, {});
    Rational volumes[2] = {0, 0};
    for (std::uint32_t level = 0; level < 2; ++level) {
      WalkOptions options;
      options.level = level;
      for (const Piece& piece : pieces_of(tree, options)) {
        volumes[level] += exact_volume(piece.polyhedron, tree.plane_set());
      }
    }
    EXPECT_EQ(volumes[0], volumes[1]);
  }
}

TEST(WalkPieces, TakesLevelsBeyondTheTreeAsItsLast) {
  const Octree tree = every_kind_tree();
  WalkOptions last;
  last.level = 2;
  WalkOptions beyond;
  beyond.level = 100;
  EXPECT_EQ(pieces_of(tree, last).size(), pieces_of(tree, beyond).size());
  EXPECT_EQ(pieces_of(tree, last).size(), pieces_of(tree, {}).size());
}

/// The part of a ray (from + t * along, t > smallest) inside a piece; empty if from >= to.
struct Interval {
  double from;
  double to;
};
Interval ray_in_piece(const Piece& piece, Vec3 from, Vec3 along, double smallest) {
  Interval interval{smallest, 1e300};
  for (const Plane& plane : piece.half_spaces) {
    const double slope = glm::dot(plane.normal, along);
    const double value = glm::dot(plane.normal, from) - plane.offset;
    if (std::abs(slope) < 1e-14) {
      if (value > -1e-12) return {1, 0};  // along a face is not inside
    } else if (slope > 0) {
      interval.to = std::min(interval.to, -value / slope);
    } else {
      interval.from = std::max(interval.from, -value / slope);
    }
  }
  return interval;
}

void expect_front_to_back(const Octree& tree, const Viewpoint& viewpoint, Random& random,
                          int& hidden) {
  WalkOptions options;
  options.level = random.below(4);
  options.viewpoint = viewpoint;
  const std::vector<Piece> pieces = pieces_of(tree, options);
  if (pieces.empty()) return;
  for (int k = 0; k < 30; ++k) {
    const Vec3 target =
        k % 2 == 0 ? pieces[random.below(static_cast<std::uint32_t>(pieces.size()))].centroid
                   : random_vector(random, 1);
    const bool is_point = viewpoint.w == 1;
    const Vec3 from = is_point ? viewpoint.xyz : target;
    const Vec3 along = is_point ? target - viewpoint.xyz : -viewpoint.xyz;
    double depth = -1e300;  // how far the pieces so far reach back
    for (const Piece& piece : pieces) {
      const Interval interval = ray_in_piece(piece, from, along, is_point ? 0 : -1e300);
      if (interval.to - interval.from < 1e-9) continue;
      hidden += depth > -1e300;
      EXPECT_GE(interval.from, depth - 1e-9) << "a later piece hides an earlier one";
      depth = std::max(depth, interval.to);
    }
  }
}

TEST(WalkPieces, ComesFrontToBackForEveryViewpoint) {
  Random random(2);
  int hidden = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Octree tree = any_tree(seed);
    for (int k = 0; k < 12; ++k) {
      Viewpoint viewpoint;
      switch (k) {
        case 0:
        case 1:  // parallel
          viewpoint = {random_direction(random), 0};
          break;
        case 2:
        case 3: {  // parallel, along an axis or a diagonal: walls and planes are seen edge-on
          Vec3 direction{0.0};
          while (direction == Vec3{0.0}) {
            for (int i = 0; i < 3; ++i) direction[i] = random_integer(random, -1, 1);
          }
          viewpoint = {direction, 0};
          break;
        }
        case 4:
        case 5:  // from outside
          viewpoint = {random_direction(random) * random.between(2, 10), 1};
          break;
        case 6:  // from far away
          viewpoint = {random_direction(random) * 1e6, 1};
          break;
        case 7:
        case 8:  // from within
          viewpoint = {random_vector(random, 1), 1};
          break;
        case 9:  // from within walls and planes
          viewpoint = {random_grid_point(random, 2), 1};
          break;
        default: {  // from outside, within the walls' planes
          Vec3 point = random_grid_point(random, 1);
          point[random_integer(random, 0, 2)] = 3;
          viewpoint = {point, 1};
          break;
        }
      }
      expect_front_to_back(tree, viewpoint, random, hidden);
    }
  }
  EXPECT_GT(hidden, 5000);
}

TEST(WalkPieces, YieldsTheSameSolidInEveryOrder) {
  Random random(3);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Octree tree = any_tree(seed);
    const std::vector<Piece> plain = pieces_of(tree, {});
    WalkOptions options;
    options.viewpoint = Viewpoint{random_vector(random, 3), 1};
    const std::vector<Piece> ordered = pieces_of(tree, options);
    ASSERT_EQ(plain.size(), ordered.size());
    const auto cells = [](const std::vector<Piece>& pieces) {
      std::map<std::pair<std::uint32_t, std::uint32_t>, double> volumes;
      for (const Piece& piece : pieces) {
        volumes[{piece.address.level, piece.address.index}] += volume(piece.polyhedron);
      }
      return volumes;
    };
    const auto expected = cells(plain);
    const auto found = cells(ordered);
    ASSERT_EQ(expected.size(), found.size());
    for (const auto& [cell, value] : expected) EXPECT_NEAR(found.at(cell), value, 1e-12);
  }
}

/// Checks how calls nest, and skips some subtrees.
class NestingCheck : public PieceVisitor {
 public:
  NestingCheck(const Octree& tree, std::uint32_t last_level, std::uint64_t seed, double skipped)
      : tree_(tree), last_level_(last_level), random_(seed), skipped_(skipped) {}
  ~NestingCheck() override { EXPECT_TRUE(open_.empty()); }

  bool enter(const NodeAddress& address, NodeKind kind, const Polyhedron& region) override {
    EXPECT_EQ(kind, tree_.levels[address.level].kinds[address.index]);
    EXPECT_NE(kind, NodeKind::White);
    EXPECT_EQ(address.level, open_.size());
    const bool is_root = open_.empty();
    std::vector<Plane> half_spaces;
    if (!is_root) {
      Open& parent = open_.back();
      EXPECT_TRUE(parent.had_inner);
      const std::uint32_t first =
          tree_.levels[parent.address.level].first_child[parent.address.index];
      EXPECT_GE(address.index, first);
      EXPECT_LT(address.index, first + 8);
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t upper = ((address.index - first) >> axis) & 1;
        EXPECT_EQ(address.lower[axis], parent.address.lower[axis] + upper * address.size());
      }
    } else {
      EXPECT_EQ(address.index, 0u);
    }
    // The region is the cube within the ancestors' half-spaces.
    const PlaneSet planes = tree_.plane_set();
    for (int axis = 0; axis < 3; ++axis) {
      half_spaces.push_back(planes[PlaneRef::of_wall(axis, address.lower[axis]).flipped()]);
      half_spaces.push_back(planes[PlaneRef::of_wall(axis, address.lower[axis] + address.size())]);
    }
    for (const Open& open : open_) {
      for (const std::uint32_t plane :
           tree_.levels[open.address.level].planes_of(open.address.index)) {
        half_spaces.push_back(tree_.planes[plane]);
      }
    }
    if (half_spaces.size() <= 9) {
      EXPECT_EQ(exact_vertices(region, planes), enumerated_vertices(half_spaces));
    }
    ++entered;
    if (random_.chance(skipped_)) {
      ++skipped_count;
      return false;
    }
    open_.push_back({address, 0, false});
    return true;
  }
  void inner(const NodeAddress& address, const Polyhedron& region) override {
    ASSERT_FALSE(open_.empty());
    EXPECT_TRUE(is_open(address));
    EXPECT_FALSE(open_.back().had_inner);
    EXPECT_EQ(tree_.levels[address.level].kinds[address.index], NodeKind::Grey);
    EXPECT_LT(address.level, last_level_);
    EXPECT_EQ(structure_error(region, tree_.plane_set()), "");
    open_.back().had_inner = true;
  }
  void piece(const NodeAddress& address, NodeKind, std::uint32_t part, const Polyhedron&) override {
    ASSERT_FALSE(open_.empty());
    EXPECT_TRUE(is_open(address));
    EXPECT_EQ(part, open_.back().parts++);
    EXPECT_FALSE(open_.back().had_inner);
    ++pieces;
  }
  void leave(const NodeAddress& address) override {
    ASSERT_FALSE(open_.empty());
    EXPECT_TRUE(is_open(address));
    open_.pop_back();
    ++left;
  }

  int entered = 0;
  int skipped_count = 0;
  int left = 0;
  int pieces = 0;

 private:
  struct Open {
    NodeAddress address;
    std::uint32_t parts;
    bool had_inner;
  };
  bool is_open(const NodeAddress& address) const {
    return open_.back().address.level == address.level &&
           open_.back().address.index == address.index;
  }
  const Octree& tree_;
  const std::uint32_t last_level_;
  Random random_;
  const double skipped_;
  std::vector<Open> open_;
};

TEST(WalkPieces, BracketsNodesAndPassesOverWhatItIsToldToSkip) {
  int skipped = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Octree tree = any_tree(seed);
    const auto last = static_cast<std::uint32_t>(tree.levels.size()) - 1;
    NestingCheck whole(tree, last, seed, 0);
    walk_pieces(tree, {}, whole);
    EXPECT_EQ(whole.left, whole.entered);
    NestingCheck some(tree, last, seed, 0.3);
    WalkOptions options;
    options.viewpoint = Viewpoint{{1, 2, 3}, 0};
    walk_pieces(tree, options, some);
    EXPECT_EQ(some.left, some.entered - some.skipped_count);
    EXPECT_LE(some.pieces, whole.pieces);
    skipped += some.skipped_count;
    NestingCheck none(tree, last, seed, 1);
    walk_pieces(tree, {}, none);
    EXPECT_LE(none.entered, 1);
    EXPECT_EQ(none.pieces, 0);
    EXPECT_EQ(none.left, 0);
  }
  EXPECT_GT(skipped, 30);
}

TEST(WalkPieces, BearsUnionsAndExpressionsOfAnyDepth) {
  // Slices of one cube, one within the other: as deep as there are planes.
  constexpr std::uint32_t kCount = 3000;
  Octree tree;
  std::vector<std::uint32_t> references;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    Plane plane;
    plane.normal.x = 1;
    plane.offset = -1 + (i + 1) * 0x1p-12;
    tree.planes.push_back(plane);
    references.push_back(i);
  }
  tree.levels.emplace_back().append(NodeKind::Concave, references);
  for (const double x : {-5.0, 0.0, 5.0}) {
    WalkOptions options;
    options.viewpoint = Viewpoint{{x, 0, 0}, 1};
    EXPECT_EQ(pieces_of(tree, options).size(), kCount);
  }
  // The same slices, every other one of material, as an expression: out if ..., else in if ...
  std::vector<std::uint32_t> tokens;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    tokens.push_back(kFirstPlaneToken + i);
    tokens.push_back(i % 2 == 0 ? kInToken : kOutToken);
  }
  tokens.push_back(kOutToken);
  tree.levels[0] = Level();
  tree.levels[0].append(NodeKind::Vertex, references, tokens);
  for (const double x : {-5.0, 0.0, 5.0}) {
    WalkOptions options;
    options.viewpoint = Viewpoint{{x, 0, 0}, 1};
    EXPECT_EQ(pieces_of(tree, options).size(), kCount / 2);
  }
}

}  // namespace
}  // namespace spoctree
