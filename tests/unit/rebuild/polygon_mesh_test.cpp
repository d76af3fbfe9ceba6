#include "client/rebuild/polygon_mesh.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/sample_trees.hpp"
#include "tests/support/surface_judge.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

/// A plate one cell thick with rectangular holes, as a surface.
Octree plate(int depth, std::function<bool(int, int)> is_hole) {
  Voxels voxels;
  voxels.depth = depth;
  voxels.contains = [is_hole](int x, int y, int z) { return z == 1 && !is_hole(x, y); };
  return tree_of(voxels);
}

/// Area vectors of polygons must not be turned over: all of a plane plate's lie along an axis.
double smallest_area(const PolygonMesh& mesh) {
  double smallest = 1e9;
  for (std::size_t i = 0; i < mesh.polygon_count(); ++i) {
    const Vec3 origin = mesh.vertices[mesh.corners[mesh.polygon_begin[i]]];
    Vec3 sum{0.0};
    for (std::uint32_t k = mesh.polygon_begin[i] + 1; k + 1 < mesh.polygon_begin[i + 1]; ++k) {
      sum += glm::cross(mesh.vertices[mesh.corners[k]] - origin,
                        mesh.vertices[mesh.corners[k + 1]] - origin);
    }
    smallest = std::min(smallest, 0.5 * glm::length(sum));
  }
  return smallest;
}

TEST(MakePolygonMesh, KeepsFacesWithoutHolesAsTheyAre) {
  const Octree tree = cube_tree();
  const PolygonMesh mesh = make_polygon_mesh(rebuild_surface(tree), tree.universe);
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.polygon_count(), 6u);
  EXPECT_EQ(faults_of(mesh), std::vector<std::string>{});
  // A cube of side 2 around (10, 20, 30).
  EXPECT_NEAR(volume_of(mesh), 8, 1e-12);
  for (const Vec3 vertex : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(std::abs(vertex[axis] - 10 * (axis + 1)), 1, 1e-12);
    }
  }
}

TEST(MakePolygonMesh, CutsAFaceWithOneHoleIntoTwoPolygonsWithoutNewVertices) {
  const Octree tree = plate(3, [](int x, int y) { return x >= 3 && x < 6 && y >= 2 && y < 4; });
  const PolygonMesh mesh = make_polygon_mesh(rebuild_surface(tree), tree.universe);
  EXPECT_EQ(mesh.vertices.size(), 16u);
  EXPECT_EQ(mesh.polygon_count(), 8u + 2 * 2);
  EXPECT_EQ(faults_of(mesh), std::vector<std::string>{});
  EXPECT_NEAR(volume_of(mesh), (64 - 6) * 0.25 * 0.25 * 0.25, 1e-12);
}

TEST(MakePolygonMesh, CutsAFaceWithRowsOfHolesInLine) {
  const Octree tree = plate(5, [](int x, int y) { return x % 3 == 1 && y % 3 == 1; });
  const Surface surface = rebuild_surface(tree);
  const PolygonMesh mesh = make_polygon_mesh(surface, tree.universe);
  EXPECT_EQ(mesh.vertices.size(), surface.vertices.size());
  EXPECT_EQ(faults_of(mesh), std::vector<std::string>{});
  EXPECT_NEAR(volume_of(mesh), volume(surface), 1e-12);
  EXPECT_GT(smallest_area(mesh), 1e-6);
}

TEST(MakePolygonMesh, CutsFacesWithHolesThatTouchEachOtherAndTheirOutline) {
  const Octree tree = plate(4, [](int x, int y) { return (x + y) % 2 == 0 && x % 5 != 3; });
  const Surface surface = rebuild_surface(tree);
  const PolygonMesh mesh = make_polygon_mesh(surface, tree.universe);
  EXPECT_EQ(faults_of(mesh), std::vector<std::string>{});
  EXPECT_NEAR(volume_of(mesh), volume(surface), 1e-12);
  EXPECT_GT(smallest_area(mesh), 1e-6);
}

TEST(MakePolygonMesh, CutsAMengerSponge) {
  Voxels voxels;
  voxels.depth = 5;
  voxels.contains = [](int x, int y, int z) {
    return x < 27 && y < 27 && z < 27 && in_menger_sponge(x, y, z, 3);
  };
  const Octree tree = tree_of(voxels);
  const Surface surface = rebuild_surface(tree);
  EXPECT_EQ(faults_of(surface, tree), std::vector<std::string>{});
  const PolygonMesh mesh = make_polygon_mesh(surface, tree.universe);
  EXPECT_EQ(faults_of(mesh), std::vector<std::string>{});
  EXPECT_NEAR(volume_of(mesh), 20 * 20 * 20 / (16.0 * 16 * 16), 1e-11);
  EXPECT_GT(smallest_area(mesh), 1e-6);
}

TEST(ToOff, WritesCountsVerticesAndPolygons) {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}, {0, 0, -1e300}};
  mesh.corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  mesh.polygon_begin = {0, 3, 6, 9, 12};
  EXPECT_EQ(to_off(mesh),
            "OFF\n4 4 6\n0 0 0\n1 0 0\n0 0.1 0\n0 0 -1e+300\n"
            "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
}

}  // namespace
}  // namespace spoctree
