#include "client/lines/line_source.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "common/tree/node_address.hpp"
#include "tests/support/random.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

/// The leaf of T_level around a point, and how far from the point its nearest wall is: found by
/// looking at all leaves.
struct Found {
  NodeKind kind = NodeKind::White;
  std::uint32_t level = 0;
  double to_wall = -1;
};

void look(const Octree& tree, std::uint32_t last_level, const NodeAddress& node, Vec3 point,
          Found& found) {
  const Level& nodes = tree.levels[node.level];
  if (nodes.kinds[node.index] == NodeKind::Grey && node.level < last_level) {
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      look(tree, last_level, node.child(nodes.first_child[node.index], octant), point, found);
    }
    return;
  }
  double to_wall = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = tree.universe.half_side;
    const double lower = wall_coordinate(half, node.lower[axis]);
    const double upper = wall_coordinate(half, node.lower[axis] + node.size());
    to_wall = std::min({to_wall, point[axis] - lower, upper - point[axis]});
  }
  if (to_wall < 0) return;
  found = {nodes.kinds[node.index], node.level, to_wall};
}

TEST(FindSources, NamesTheLeavesThatALineRunsThrough) {
  Random random(11);
  const Octree tree = tree_of({4, [](int x, int y, int z) {
                                 return (x * 7 + y * 5 + z * 3) % 11 < 4 && (x + y + z) % 16 < 9;
                               }});
  for (const std::uint32_t level : {0u, 2u, 4u}) {
    VisibleLines lines;
    for (int k = 0; k < 200; ++k) {
      VisibleLine line;
      for (int axis = 0; axis < 3; ++axis) {
        line.a[axis] = random.between(-0.99, 0.99);
        // Some lines are parallel to an axis, some short.
        line.b[axis] = random.chance(0.3)   ? line.a[axis]
                       : random.chance(0.5) ? random.between(-0.99, 0.99)
                                            : line.a[axis] + 1e-3;
      }
      if (line.a == line.b) continue;
      // Two sides of a wall: nothing says which side the material is on.
      line.planes[0] = PlaneRef::of_wall(0, 3);
      line.planes[1] = line.planes[0].flipped();
      lines.push_back(line);
    }
    find_sources(lines, tree, level);
    std::size_t looked_at = 0;
    for (const VisibleLine& line : lines) {
      double begin = 0;
      for (const LineStretch& stretch : stretches_of(line)) {
        for (const double part : {0.05, 0.3, 0.5, 0.9}) {
          const double t = begin + part * (stretch.end - begin);
          Found found;
          look(tree, level, {}, line.a + t * (line.b - line.a), found);
          if (found.to_wall < 1e-6) continue;
          ++looked_at;
          EXPECT_EQ(stretch.source.kind, found.kind);
          EXPECT_EQ(stretch.source.level, found.level);
        }
        begin = stretch.end;
      }
      EXPECT_EQ(begin, 1);
    }
    EXPECT_GT(looked_at, 500u);
  }
}

TEST(FindSources, TakeTheSideOfTheMaterial) {
  // One cell of eight is material; its edges lie on the walls of others, which are not.
  const Octree tree = tree_of({1, [](int x, int y, int z) { return x == 0 && y == 0 && z == 0; }});
  VisibleLine line;
  line.a = {0, 0, -0.9};
  line.b = {0, 0, -0.1};
  const auto middle = std::uint32_t{1} << (kMaxDepth - 1);
  line.planes[0] = PlaneRef::of_wall(0, middle);
  line.planes[1] = PlaneRef::of_wall(1, middle);
  // Walls face towards higher coordinates, or are flipped.
  for (const bool faces_up : {true, false}) {
    VisibleLines lines = {line};
    for (PlaneRef& plane : lines[0].planes) {
      if ((tree.plane_set()[plane].normal.x + tree.plane_set()[plane].normal.y > 0) != faces_up) {
        plane = plane.flipped();
      }
    }
    find_sources(lines, tree, 9);
    EXPECT_EQ(lines[0].source.kind, faces_up ? NodeKind::Black : NodeKind::White);
  }
}

}  // namespace
}  // namespace spoctree
