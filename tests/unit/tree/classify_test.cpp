// Point queries against the definition of the tree, on planes, walls, edges and corners too.
#include "common/tree/classify.hpp"

#include <gtest/gtest.h>

#include "common/tree/validate.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/grid_planes.hpp"
#include "tests/support/sample_trees.hpp"
#include "tests/support/tree_definition.hpp"

namespace spoctree {
namespace {

PointClass expected_class(const Octree& tree, std::uint32_t level, Vec3 point) {
  const RationalPoint exact = to_rational(point);
  bool has_in = false;
  bool has_out = false;
  bool has_unknown = false;
  for (const RationalPoint& direction : directions_around(tree, level, exact)) {
    const TreeValue value = value_of_definition(tree, level, exact, direction);
    has_unknown |= !value.is_known;
    has_in |= value.is_known && value.is_material;
    has_out |= value.is_known && !value.is_material;
  }
  EXPECT_TRUE(has_in || has_out || has_unknown);
  if (has_in && has_out) return PointClass::On;
  if (has_unknown) return PointClass::Unknown;
  return has_in ? PointClass::In : PointClass::Out;
}

Octree leaf_tree(NodeKind kind, std::vector<Plane> planes,
                 std::span<const std::uint32_t> expression = {}) {
  Octree tree;
  tree.planes = std::move(planes);
  std::vector<std::uint32_t> references;
  for (std::uint32_t i = 0; i < tree.planes.size(); ++i) references.push_back(i);
  tree.levels.emplace_back().append(kind, references, expression);
  return tree;
}

Plane axis_plane(int axis, double sign, double offset) {
  Plane plane;
  plane.normal[axis] = sign;
  plane.offset = offset;
  return plane;
}

TEST(ClassifyPoint, AgreesWithTheDefinitionAtGenericPoints) {
  Random random(1);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Octree tree = random_tree(seed);
    const auto levels = static_cast<std::uint32_t>(tree.levels.size());
    for (std::uint32_t level = 0; level <= levels; ++level) {
      for (int k = 0; k < 30; ++k) {
        const Vec3 point = random_vector(random, 1);
        const TreeValue value =
            value_of_definition(tree, std::min(level, levels - 1), to_rational(point), {1, 1, 1});
        const PointClass expected = !value.is_known     ? PointClass::Unknown
                                    : value.is_material ? PointClass::In
                                                        : PointClass::Out;
        EXPECT_EQ(classify_point(tree, point, level), expected);
      }
    }
  }
}

TEST(ClassifyPoint, AgreesWithTheDefinitionOnPlanesWallsEdgesAndCorners) {
  Random random(2);
  int counts[4] = {0, 0, 0, 0};
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Octree tree = degenerate_tree(seed, 4);
    ASSERT_TRUE(validate(tree).empty()) << validate(tree).front();
    for (int k = 0; k < 25; ++k) {
      // Corners of cells of any depth, on the walls of the universe too; then points of edges and
      // faces of cells; points near all of those.
      Vec3 point = random_grid_point(random, random_integer(random, 0, 3), 1.25);
      if (k % 5 == 1) point[random_integer(random, 0, 2)] = random.between(-1, 1);
      if (k % 5 == 2) point[random_integer(random, 0, 2)] += 0x1p-52;
      for (int axis = 0; axis < 3; ++axis) point[axis] = std::clamp(point[axis], -1.0, 1.0);
      for (const std::uint32_t level : {1u, 9u}) {
        const auto looked_at = std::min(level, static_cast<std::uint32_t>(tree.levels.size()) - 1);
        const PointClass expected = expected_class(tree, looked_at, point);
        ++counts[static_cast<int>(expected)];
        EXPECT_EQ(classify_point(tree, point, level), expected)
            << "seed " << seed << " level " << level << " point " << point.x << ' ' << point.y
            << ' ' << point.z;
      }
    }
  }
  for (const int count : counts) EXPECT_GT(count, 50);
}

TEST(ClassifyPoint, TakesWallsBetweenCellsOfMaterialAsInside) {
  Octree tree;
  tree.levels.resize(2);
  tree.levels[0].append(NodeKind::Grey, {});
  for (int octant = 0; octant < 8; ++octant) {
    tree.levels[1].append(octant == 7 ? NodeKind::White : NodeKind::Black, {});
  }
  EXPECT_EQ(classify_point(tree, {-0.5, 0, -0.25}), PointClass::In);  // between two black cells
  EXPECT_EQ(classify_point(tree, {-0.5, 0, 0}), PointClass::In);      // among four
  EXPECT_EQ(classify_point(tree, {0.5, 0.5, 0}), PointClass::On);     // below the white one
  EXPECT_EQ(classify_point(tree, {0, 0, 0.5}), PointClass::On);
  EXPECT_EQ(classify_point(tree, {0, 0, 0}), PointClass::On);
  EXPECT_EQ(classify_point(tree, {0.5, 0.5, 0.5}), PointClass::Out);
  EXPECT_EQ(classify_point(tree, {1, 0.5, 0.5}), PointClass::Out);  // white and the universe's end
  EXPECT_EQ(classify_point(tree, {-1, 0.5, 0.5}), PointClass::On);  // black and the universe's end
  EXPECT_EQ(classify_point(tree, {-1, 0.5, 0.5}, 0), PointClass::Unknown);
  EXPECT_EQ(classify_point(tree, {0.5, 0.5, 0.5}, 0), PointClass::Unknown);
}

TEST(ClassifyPoint, TakesPlanesWithMaterialOnBothSidesAsInside) {
  // Two half-spaces that fill all space between them: their common plane is no boundary.
  const Octree tree =
      leaf_tree(NodeKind::Concave, {axis_plane(0, 1, 0.25), axis_plane(0, -1, -0.25)});
  EXPECT_EQ(classify_point(tree, {0.25, 0.1, 0.1}), PointClass::In);
  EXPECT_EQ(classify_point(tree, {0.5, 0.1, 0.1}), PointClass::In);
  // And the intersection of the two, which has no interior: nothing.
  const Octree sheet =
      leaf_tree(NodeKind::Convex, {axis_plane(0, 1, 0.25), axis_plane(0, -1, -0.25)});
  EXPECT_EQ(classify_point(sheet, {0.25, 0.1, 0.1}), PointClass::Out);
  EXPECT_EQ(classify_point(sheet, {0.2, 0.1, 0.1}), PointClass::Out);
}

TEST(ClassifyPoint, KnowsACubesFacesEdgesAndCorners) {
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) planes.push_back(axis_plane(axis, sign, 0.5));
  }
  const Octree tree = leaf_tree(NodeKind::Convex, planes);
  for (const double x : {-0.75, -0.5, -0.25, 0.0, 0.5, 0.5 + 0x1p-52, 0.5 - 0x1p-53}) {
    for (const double y : {-0.5, 0.0, 0.1, 0.5}) {
      const double largest = std::max(std::abs(x), std::abs(y));
      const PointClass expected = largest > 0.5    ? PointClass::Out
                                  : largest == 0.5 ? PointClass::On
                                                   : PointClass::In;
      EXPECT_EQ(classify_point(tree, {x, y, 0.25}), expected);
      EXPECT_EQ(classify_point(tree, {y, 0.25, x}), expected);
    }
  }
}

TEST(ClassifyPoint, IsOutsideBeyondTheUniverse) {
  const Octree tree = leaf_tree(NodeKind::Black, {});
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double x : {kNaN, kInfinity, -kInfinity, 1.0 + 0x1p-52, -2.0, 1e300}) {
    EXPECT_EQ(classify_point(tree, {x, 0, 0}), PointClass::Out);
    EXPECT_EQ(classify_point(tree, {0, 0, x}), PointClass::Out);
  }
  EXPECT_EQ(classify_point(tree, {0, 0, 0}), PointClass::In);
  EXPECT_EQ(classify_point(tree, {1, 1, -1}), PointClass::On);
}

TEST(ClassifyPoint, BearsExpressionsAndUnionsOfAnyDepth) {
  // Nested as deep as there are planes, all of them through one point.
  Random random(3);
  constexpr std::uint32_t kCount = 3000;
  std::vector<Plane> planes;
  std::vector<std::uint32_t> tokens;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    planes.push_back(random_plane_exactly_through(random, {0.25, 0.5, -0.25}, 2));
    tokens.push_back(kFirstPlaneToken + i);
  }
  for (std::uint32_t i = 0; i < kCount; ++i) {
    tokens.push_back(kInToken);
    tokens.push_back(kOutToken);
  }
  tokens.resize(2 * kCount);
  tokens.push_back(kOutToken);
  ASSERT_TRUE(is_well_formed(tokens, kCount));
  const Octree deep = leaf_tree(NodeKind::Vertex, planes, tokens);
  EXPECT_EQ(classify_point(deep, {0.25, 0.5, -0.25}), PointClass::On);
  const Octree wide = leaf_tree(NodeKind::Concave, planes);
  EXPECT_EQ(classify_point(wide, {0.25, 0.5, -0.25}), PointClass::In);  // planes all around
}

}  // namespace
}  // namespace spoctree
