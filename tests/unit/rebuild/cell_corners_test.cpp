// The corners of a cell's material found by signs alone, against those of its pieces as polyhedra.
#include "client/rebuild/cell_corners.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "client/rebuild/polyhedron_corners.hpp"
#include "common/tree/pieces.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

using Corners = std::map<std::array<std::uint32_t, 3>, std::int32_t>;

Corners take(CornerSum& sum) {
  Corners corners;
  sum.flush([&](const CornerCount& corner) {
    corners[{corner.planes[0], corner.planes[1], corner.planes[2]}] = corner.count;
  });
  return corners;
}

/// Every leaf of a tree, with all planes of its ancestors.
class LeafComparison {
 public:
  explicit LeafComparison(const Octree& tree)
      : tree_(tree), carriers_(tree), cell_corners_(tree, carriers_) {}

  void compare(const NodeAddress& node, const std::vector<std::uint32_t>& bounds) {
    const Level& level = tree_.levels[node.level];
    const NodeKind kind = level.kinds[node.index];
    const auto planes = level.planes_of(node.index);
    if (kind == NodeKind::White) return;
    if (kind == NodeKind::Grey) {
      std::vector<std::uint32_t> more = bounds;
      more.insert(more.end(), planes.begin(), planes.end());
      for (std::uint32_t octant = 0; octant < 8; ++octant) {
        compare(node.child(level.first_child[node.index], octant), more);
      }
      return;
    }
    CornerSum sum;
    CubeCorners cube{};
    if (!cell_corners_.find(node, kind, planes, level.expression_of(node.index), bounds,
                            bounds.size(), cube, sum)) {
      ++left_out;
      EXPECT_TRUE(take(sum).empty());
      return;
    }
    for (std::uint32_t i = 0; i < 8; ++i) {
      const auto wall = [&](int axis, std::uint32_t upper) {
        const std::uint32_t at = node.lower[axis] + upper * node.size();
        return carriers_.number_of(PlaneRef::of_wall(axis, at));
      };
      sum.add(wall(0, i & 1), wall(1, (i >> 1) & 1), wall(2, i >> 2), cube[i]);
    }
    const Corners found = take(sum);
    PolyhedronCorners polyhedra(carriers_, sum);
    walk_pieces(tree_, {}, Subtree{node, bounds}, polyhedra);
    EXPECT_EQ(found, take(sum)) << "level " << node.level << " node " << node.index;
    ++compared;
    corners += found.size();
  }

  std::size_t compared = 0;
  std::size_t left_out = 0;
  std::size_t corners = 0;

 private:
  const Octree& tree_;
  const Carriers carriers_;
  CellCorners cell_corners_;
};

TEST(CellCorners, AreThoseOfThePiecesInRandomTrees) {
  std::size_t compared = 0;
  std::size_t corners = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Octree tree = random_tree(seed, {.levels = 5, .max_nodes = 600});
    LeafComparison comparison(tree);
    comparison.compare({}, {});
    compared += comparison.compared;
    corners += comparison.corners;
  }
  EXPECT_GT(compared, 2000u);
  EXPECT_GT(corners, 5000u);
}

TEST(CellCorners, AreThoseOfThePiecesOrLeftToOthersInDegenerateTrees) {
  std::size_t compared = 0;
  std::size_t left_out = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Octree tree = degenerate_tree(seed, 4);
    LeafComparison comparison(tree);
    comparison.compare({}, {});
    compared += comparison.compared;
    left_out += comparison.left_out;
  }
  EXPECT_GT(compared, 300u);
  EXPECT_GT(left_out, 300u);
}

TEST(CellCorners, AreFoundWherePlanesMeetInAClusterOfPoints) {
  // Six planes around one point, each off it by a few steps of the grid: a VERTEX node in which the
  // material is between them, in all ways.
  std::size_t corners = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    Octree tree;
    const Vec3 centre{random.between(-0.5, 0.5), random.between(-0.5, 0.5),
                      random.between(-0.5, 0.5)};
    std::vector<std::uint32_t> all;
    std::vector<std::uint32_t> tokens;
    for (std::uint32_t i = 0; i < 6; ++i) {
      tree.planes.push_back(random_plane(random, centre, 1e-15));
      all.push_back(i);
      tokens.push_back(kFirstPlaneToken + i);
      // A chain: in or out inside each plane.
      tokens.push_back(random.chance(0.5) ? kInToken : kOutToken);
    }
    tokens.push_back(kInToken);
    tree.levels.emplace_back().append(NodeKind::Vertex, all, tokens);
    LeafComparison comparison(tree);
    comparison.compare({}, {});
    EXPECT_EQ(comparison.left_out, 0u);
    corners += comparison.corners;
  }
  EXPECT_GT(corners, 3000u);
}

TEST(CornerSum, CountsACornerByItsPlanesInAnyOrder) {
  CornerSum sum;
  sum.add(7, 3, 5, 1);  // an even permutation of 3 5 7
  sum.add(5, 3, 7, 1);  // an odd one
  EXPECT_TRUE(take(sum).empty());
  sum.add(5, 7, 3, 2);
  sum.add(3, 7, 5, -1);
  EXPECT_EQ(take(sum), (Corners{{{3, 5, 7}, 3}}));
}

}  // namespace
}  // namespace spoctree
