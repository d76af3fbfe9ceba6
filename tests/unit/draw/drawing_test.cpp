#include "client/draw/drawing.hpp"

#include <gtest/gtest.h>

#include "client/lines/extent.hpp"
#include "common/base/errors.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

VisibleLine line(Vec3 a, Vec3 b, LineKind kind = LineKind::Crease, bool hidden = false) {
  return {a, b, kind, hidden, false, {}, {}};
}

PageOptions page(Vec2 lower, Vec2 upper) {
  PageOptions options;
  options.frame = {lower, upper};
  options.size = 120;
  options.margin = 10;
  return options;
}

TEST(Drawing, FitsTheFrameBetweenTheMargins) {
  const Camera camera(Vec3{0, -1, 0});
  const Drawing drawing =
      make_drawing({line({-1, 0, -0.5}, {1, 0, 0.5})}, camera, page({-1, -0.5}, {1, 0.5}));
  EXPECT_DOUBLE_EQ(drawing.width, 120);
  EXPECT_DOUBLE_EQ(drawing.height, 70);
  ASSERT_EQ(drawing.strokes(Layer::Crease).size(), 1u);
  const Stroke& stroke = drawing.strokes(Layer::Crease)[0];
  // Left and below is at the left margin and at the foot of the page.
  EXPECT_DOUBLE_EQ(stroke[0].x, 10);
  EXPECT_DOUBLE_EQ(stroke[0].y, 60);
  EXPECT_DOUBLE_EQ(stroke[1].x, 110);
  EXPECT_DOUBLE_EQ(stroke[1].y, 10);
}

TEST(Drawing, MakesOneStrokeOfLinesThatFollowEachOther) {
  const Camera camera(Vec3{0, 0, 1});
  const VisibleLines lines = {line({0, 0, 0}, {1, 0, 0}), line({1, 0, 0}, {1, 1, 0}),
                              line({0, 1, 0}, {0, 0, 0}),
                              line({0, 0, 0}, {0.5, 0, 0}, LineKind::Silhouette),
                              line({0.5, 0, 0}, {0.5, 1, 0}, LineKind::Crease, true)};
  const Drawing drawing = make_drawing(lines, camera, page({0, 0}, {1, 1}));
  ASSERT_EQ(drawing.strokes(Layer::Crease).size(), 2u);
  EXPECT_EQ(drawing.strokes(Layer::Crease)[0].size(), 3u);
  EXPECT_EQ(drawing.strokes(Layer::Crease)[1].size(), 2u);
  EXPECT_EQ(drawing.strokes(Layer::Silhouette).size(), 1u);
  EXPECT_EQ(drawing.strokes(Layer::Hidden).size(), 1u);
}

TEST(Drawing, RejectsAPageWithoutRoom) {
  const Camera camera;
  EXPECT_THROW(make_drawing({}, camera, page({0, 0}, {0, 1})), UsageError);
  PageOptions narrow = page({0, 0}, {1, 1});
  narrow.margin = 60;
  EXPECT_THROW(make_drawing({}, camera, narrow), UsageError);
  narrow.margin = std::nan("");
  EXPECT_THROW(make_drawing({}, camera, narrow), UsageError);
}

TEST(Extent, IsThatOfTheCoarsestSolid) {
  // The lower half of the universe: T_0 of a tree with a GREY root without planes is the cube.
  const Voxels half{1, [](int, int, int z) { return z == 0; }};
  const Camera camera(Vec3{0, -1, 0});
  const Rectangle extent = extent_of_solid(tree_of(half), camera);
  EXPECT_EQ(extent.lower, Vec2(-1, -1));
  EXPECT_EQ(extent.upper, Vec2(1, 1));
  // One CONVEX root: T_0 is the solid.
  Octree tree;
  tree.planes = {{{0, 0, 1}, 0.25}};
  Level level;
  const std::uint32_t planes[] = {0};
  level.append(NodeKind::Convex, planes);
  tree.levels.push_back(level);
  EXPECT_EQ(extent_of_solid(tree, camera).upper, Vec2(1, 0.25));
}

TEST(Extent, IsTheUniversesIfThereIsNoSolid) {
  const Voxels nothing{1, [](int, int, int) { return false; }};
  EXPECT_EQ(extent_of_solid(tree_of(nothing), Camera(Vec3{1, 0, 0})).upper, Vec2(1, 1));
}

}  // namespace
}  // namespace spoctree
