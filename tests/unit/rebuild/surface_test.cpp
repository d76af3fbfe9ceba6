#include "client/rebuild/surface.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "common/geometry/polyhedron_clipper.hpp"
#include "tests/support/sample_trees.hpp"
#include "tests/support/surface_judge.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

/// A tree of one node in the cube of side 2 around the origin, with all planes of the table.
Octree one_node(NodeKind kind, std::vector<Plane> planes,
                std::vector<std::uint32_t> expression = {}) {
  Octree tree;
  tree.planes = std::move(planes);
  std::vector<std::uint32_t> all(tree.planes.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  tree.levels.emplace_back().append(kind, all, expression);
  return tree;
}

void expect_counts(const Surface& surface, std::size_t vertices, std::size_t edges,
                   std::size_t faces) {
  EXPECT_EQ(surface.vertices.size(), vertices);
  EXPECT_EQ(surface.edges.size(), edges);
  EXPECT_EQ(surface.faces.size(), faces);
}

TEST(RebuildSurface, OfAWhiteRootIsEmpty) {
  const Surface surface = rebuild_surface(one_node(NodeKind::White, {}));
  expect_counts(surface, 0, 0, 0);
  EXPECT_EQ(volume(surface), 0);
  EXPECT_EQ(area(surface), 0);
}

TEST(RebuildSurface, OfABlackRootIsTheUniverseCube) {
  const Octree tree = one_node(NodeKind::Black, {});
  const Surface surface = rebuild_surface(tree);
  expect_counts(surface, 8, 12, 6);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
  EXPECT_DOUBLE_EQ(volume(surface), 8);
  EXPECT_DOUBLE_EQ(area(surface), 24);
  for (const Surface::Face& face : surface.faces) EXPECT_TRUE(face.plane.is_wall());
}

TEST(RebuildSurface, NamesThePlanesOfTheTable) {
  const Octree tree = cube_tree();
  const Surface surface = rebuild_surface(tree);
  expect_counts(surface, 8, 12, 6);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
  for (const Surface::Face& face : surface.faces) {
    EXPECT_FALSE(face.plane.is_wall());
    EXPECT_FALSE(face.plane.is_flipped());
  }
}

TEST(RebuildSurface, MakesOneVertexWhereFourRoundedPlanesMeet) {
  // No multiple of 2^-52 is 1 / sqrt(3), but the octahedron has 6 vertices all the same.
  std::vector<Plane> planes;
  const double n = 0.57735026918962573;
  for (int signs = 0; signs < 8; ++signs) {
    planes.push_back(
        {{(signs & 1) != 0 ? n : -n, (signs & 2) != 0 ? n : -n, (signs & 4) != 0 ? n : -n},
         // Each a few steps of the grid off the others.
         0.375 + signs * 0x1p-51});
  }
  const Octree tree = one_node(NodeKind::Convex, planes);
  const Surface surface = rebuild_surface(tree);
  expect_counts(surface, 6, 12, 8);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
  const double radius = 0.375 * std::sqrt(3.0);
  EXPECT_NEAR(volume(surface), 4.0 / 3 * radius * radius * radius, 1e-14);
}

TEST(RebuildSurface, OfRandomConvexPolytopesIsTheirs) {
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    std::vector<Plane> planes;
    for (int i = 0; i < 40; ++i) planes.push_back(random_plane(random, Vec3{0.0}, 0.4));
    for (Plane& plane : planes) {
      if (plane.offset < 0) plane = plane.flipped();
    }
    const Octree tree = one_node(NodeKind::Convex, planes);
    Polyhedron expected = make_cell({0, 0, 0}, 1u << kMaxDepth, tree.plane_set());
    PolyhedronClipper clipper;
    for (std::uint32_t i = 0; i < planes.size(); ++i) {
      ASSERT_NE(clipper.clip(expected, PlaneRef::of_table(i), tree.plane_set()), ClipResult::Empty);
    }
    const Surface surface = rebuild_surface(tree);
    EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
    expect_counts(surface, expected.vertices.size(), expected.corners.size() / 2,
                  expected.faces.size());
    EXPECT_NEAR(volume(surface), volume(expected), 1e-13);
  }
}

const Plane kBelowX{{1, 0, 0}, 0.25};
const Plane kBelowY{{0, 1, 0}, 0.25};
const Plane kBelowZ{{0, 0, 1}, 0.25};

TEST(RebuildSurface, OfAConcaveRootHasNoLineWhereItsPiecesMeet) {
  // The cube without the corner x, y > 0.25: an L-shaped prism.
  const Octree tree = one_node(NodeKind::Concave, {kBelowX, kBelowY});
  const Surface surface = rebuild_surface(tree);
  expect_counts(surface, 12, 18, 8);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
  EXPECT_DOUBLE_EQ(volume(surface), 8 - 0.75 * 0.75 * 2);
}

TEST(RebuildSurface, OfAVertexRootIsWhatItsExpressionSays) {
  // In two opposite octants only: two cubes that touch in a vertex.
  const std::uint32_t x = kFirstPlaneToken;
  const std::uint32_t y = x + 1;
  const std::uint32_t z = x + 2;
  const Octree tree =
      one_node(NodeKind::Vertex, {kBelowX, kBelowY, kBelowZ},
               {x, y, z, kInToken, kOutToken, kOutToken, y, kOutToken, z, kOutToken, kInToken});
  const Surface surface = rebuild_surface(tree);
  expect_counts(surface, 15, 24, 12);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
  EXPECT_DOUBLE_EQ(volume(surface), 1.25 * 1.25 * 1.25 + 0.75 * 0.75 * 0.75);
}

TEST(RebuildSurface, OfAGreyFrontierIsClippedByItsPlanesOnly) {
  Octree tree = one_node(NodeKind::Grey, {kBelowX});
  tree.levels.resize(2);
  for (int i = 0; i < 8; ++i) {
    // Material in the lower half in x only.
    tree.levels[1].append(i % 2 == 0 ? NodeKind::Black : NodeKind::White, {});
  }
  const Surface coarse = rebuild_surface(tree, 0);
  expect_counts(coarse, 8, 12, 6);
  EXPECT_DOUBLE_EQ(volume(coarse), 1.25 * 4);
  const Surface fine = rebuild_surface(tree);
  expect_counts(fine, 8, 12, 6);
  EXPECT_DOUBLE_EQ(volume(fine), 4);
}

TEST(RebuildSurface, TakesAPlaneInAWallForThatWall) {
  // The plane x = 0 of the table and the wall between the children are one: children that are cut
  // by it, and children that end there, make one flat face.
  Octree tree;
  tree.planes = {{{1, 0, 0}, 0}};
  tree.levels.resize(2);
  tree.levels[0].append(NodeKind::Grey, {});
  const std::uint32_t plane[] = {0};
  for (int i = 0; i < 8; ++i) {
    if (i % 2 == 1) {
      tree.levels[1].append(NodeKind::White, {});
    } else if (i < 4) {
      tree.levels[1].append(NodeKind::Convex, plane);
    } else {
      tree.levels[1].append(NodeKind::Black, {});
    }
  }
  const Surface surface = rebuild_surface(tree);
  expect_counts(surface, 8, 12, 6);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
}

Voxels voxels_where(int depth, std::function<bool(int, int, int)> contains) {
  Voxels voxels;
  voxels.depth = depth;
  voxels.contains = std::move(contains);
  return voxels;
}

TEST(RebuildSurface, OfACubeOf512CellsHas6FacesAnd12Edges) {
  const Octree tree =
      tree_of(voxels_where(4,
                           [](int x, int y, int z) {
                             return x >= 3 && x < 11 && y >= 3 && y < 11 && z >= 5 && z < 13;
                           }),
              false);
  const Surface surface = rebuild_surface(tree);
  expect_counts(surface, 8, 12, 6);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
  EXPECT_DOUBLE_EQ(volume(surface), 1);
}

TEST(RebuildSurface, GivesAnEdgeWhereTwoCubesTouchFourSides) {
  const Octree tree =
      tree_of(voxels_where(1, [](int x, int y, int z) { return z == 0 && x == y; }));
  const Surface surface = rebuild_surface(tree);
  expect_counts(surface, 14, 23, 12);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
  std::size_t shared_by_four = 0;
  for (const Surface::Edge& edge : surface.edges) shared_by_four += edge.side_count == 4 ? 1 : 0;
  EXPECT_EQ(shared_by_four, 1u);
}

TEST(RebuildSurface, OfAPlateWithAHoleHasFacesWithAHole) {
  const Octree tree = tree_of(voxels_where(
      3, [](int x, int y, int z) { return z == 3 && !(x >= 3 && x < 6 && y >= 2 && y < 4); }));
  const Surface surface = rebuild_surface(tree);
  expect_counts(surface, 16, 24, 10);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
  std::size_t with_hole = 0;
  for (const Surface::Face& face : surface.faces) with_hole += face.loop_count == 2 ? 1 : 0;
  EXPECT_EQ(with_hole, 2u);
  EXPECT_DOUBLE_EQ(volume(surface), (64 - 6) * 0.25 * 0.25 * 0.25);
}

TEST(RebuildSurface, OfRandomCellsHasTheAreaOfTheirBoundarySquares) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    constexpr int kSide = 16;
    std::vector<bool> cells(kSide * kSide * kSide);
    const double density = random.between(0.02, 0.98);
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = random.chance(density);
    const auto contains = [&](int x, int y, int z) {
      return cells[static_cast<std::size_t>((z * kSide + y) * kSide + x)];
    };
    const Voxels voxels = voxels_where(4, contains);
    std::size_t material = 0;
    std::size_t squares = 0;
    for (int z = -1; z < kSide; ++z) {
      for (int y = -1; y < kSide; ++y) {
        for (int x = -1; x < kSide; ++x) {
          const bool here = voxels(x, y, z);
          material += here ? 1 : 0;
          squares += here != voxels(x + 1, y, z) ? 1 : 0;
          squares += here != voxels(x, y + 1, z) ? 1 : 0;
          squares += here != voxels(x, y, z + 1) ? 1 : 0;
        }
      }
    }
    const Octree tree = tree_of(voxels);
    const Surface surface = rebuild_surface(tree);
    EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
    EXPECT_EQ(faults_of(make_polygon_mesh(surface, tree.universe)), std::vector<std::string>{});
    const double side = 0.125;
    EXPECT_NEAR(area(surface), static_cast<double>(squares) * side * side, 1e-11);
    EXPECT_NEAR(volume(surface), static_cast<double>(material) * side * side * side, 1e-11);
  }
}

}  // namespace
}  // namespace spoctree
