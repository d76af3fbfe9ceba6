#include "server/silhouettes/view_tree.hpp"

#include <gtest/gtest.h>

#include <array>

#include "server/silhouettes/triangle_quadtree.hpp"

namespace spoctree {
namespace {

NodeLimit no_limit(1'000'000'000, "nodes");

const ColouredNode* tree_of(const char* view, const Mask& mask, int depth, NodePool& pool) {
  SilhouetteRules rules;
  rules.max_depth = depth;
  return build_view_tree(*find_view(view), mask, rules, pool);
}

/// "0 5 7": the octants of the root that are black.
std::string black_octants(const ColouredNode* root) {
  std::string octants;
  for (int octant = 0; octant < 8; ++octant) {
    const ColouredNode* const child = child_of(root, octant);
    EXPECT_TRUE(is_leaf(child));
    if (child != kBlack) continue;
    if (!octants.empty()) octants += ' ';
    octants += std::to_string(octant);
  }
  return octants;
}

Mask with_pixel(int side, int column, int row) {
  Mask mask(side, side);
  mask.at(column, row) = 1;
  return mask;
}

TEST(FaceTree, GivesEachQuadrantItsTwoLabels) {
  NodePool pool(no_limit);
  EXPECT_EQ(black_octants(tree_of("face-x", with_pixel(2, 0, 0), 1, pool)), "4 5");
  EXPECT_EQ(black_octants(tree_of("face-x", with_pixel(2, 1, 0), 1, pool)), "6 7");
  EXPECT_EQ(black_octants(tree_of("face-x", with_pixel(2, 1, 1), 1, pool)), "2 3");
  EXPECT_EQ(black_octants(tree_of("face-y", with_pixel(2, 0, 0), 1, pool)), "5 7");
  EXPECT_EQ(black_octants(tree_of("face-z", with_pixel(2, 0, 0), 1, pool)), "0 4");
}

TEST(FaceTree, GivesTheSubquadrantsOfAQuadrantFourLabels) {
  NodePool pool(no_limit);
  const ColouredNode* const root = tree_of("face-x", with_pixel(4, 1, 0), 2, pool);
  for (const int octant : {4, 5}) EXPECT_EQ(black_octants(child_of(root, octant)), "6 7");
  EXPECT_EQ(child_of(root, 4), child_of(root, 5));
  for (const int octant : {0, 1, 2, 3, 6, 7}) EXPECT_EQ(child_of(root, octant), kWhite);
}

TEST(FaceTree, DividesNoSquareOfOneColour) {
  NodePool pool(no_limit);
  EXPECT_EQ(tree_of("face-z", Mask(8, 8), 3, pool), kWhite);
  Mask full(8, 8);
  full.pixels.assign(64, 1);
  EXPECT_EQ(tree_of("face-z", full, 3, pool), kBlack);
}

TEST(FaceTree, TakesAQuarterOfBlackPixelsForABlackCell) {
  NodePool pool(no_limit);
  EXPECT_EQ(tree_of("face-x", with_pixel(2, 0, 0), 0, pool), kBlack);
  EXPECT_EQ(tree_of("face-x", with_pixel(4, 0, 0), 0, pool), kWhite);
  EXPECT_EQ(black_octants(tree_of("face-x", with_pixel(4, 0, 0), 1, pool)), "4 5");
}

TEST(EdgeTree, MarksTheCentreSquareOfTwoByTwoPixelsIfEitherIsBlack) {
  // The paper's example: upper right pixel from edge 3-7 is octant 6, and with it 7 and 4.
  NodePool pool(no_limit);
  EXPECT_EQ(black_octants(tree_of("edge-37", with_pixel(2, 1, 0), 1, pool)), "4 6 7");
  EXPECT_EQ(black_octants(tree_of("edge-37", with_pixel(2, 0, 0), 1, pool)), "4 5 7");
}

TEST(EdgeTree, LooksAtCentreSquaresAndNotAtMargins) {
  // Four columns: left quadrant 0 1, centre 1 2, right 2 3.
  NodePool pool(no_limit);
  Mask mask(4, 4);
  for (const int column : {1, 2}) {
    for (const int row : {0, 1}) mask.at(column, row) = 1;
  }
  const ColouredNode* const root = tree_of("edge-37", mask, 2, pool);
  for (const int octant : {4, 7}) EXPECT_EQ(child_of(root, octant), kBlack);
  for (const int octant : {5, 6}) EXPECT_FALSE(is_leaf(child_of(root, octant)));
  for (const int octant : {0, 1, 2, 3}) EXPECT_EQ(child_of(root, octant), kWhite);
}

TEST(EdgeTree, IsTheSameForAPictureAsWideAsTheCubeLooks) {
  NodePool pool(no_limit);
  Mask wide(6, 4);
  for (int column = 3; column < 6; ++column) {
    for (int row = 0; row < 4; ++row) wide.at(column, row) = 1;
  }
  Mask square(4, 4);
  for (int column = 2; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) square.at(column, row) = 1;
  }
  EXPECT_EQ(depth_of_pixels(*find_view("edge-37"), wide), 2);
  const ColouredNode* const a = tree_of("edge-37", wide, 2, pool);
  const ColouredNode* const b = tree_of("edge-37", square, 2, pool);
  EXPECT_EQ(intersect(a, b, pool), a);
  EXPECT_EQ(intersect(b, a, pool), b);
}

/// A picture of a corner view with an octant's hexagon, by its six corners.
Mask octant_hexagon(const View& view, int octant, int size) {
  struct Point {
    double x, y;
  };
  std::array<Point, 8> points;
  const glm::dvec3 middle = glm::dvec3(towards_octant(octant)) * 0.5;
  Mask mask(size, size);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p = middle + 0.5 * glm::dvec3(towards_octant(corner));
    points[static_cast<std::size_t>(corner)] = {view.across(p), view.down(p)};
  }
  // In the hull if on no line through two points all points are on the other side.
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const Point q{(column + 0.5) / size, (row + 0.5) / size};
      bool is_inside = true;
      for (const Point& a : points) {
        for (const Point& b : points) {
          const auto side = [&](const Point& c) {
            return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
          };
          bool all_left = true;
          for (const Point& c : points) all_left = all_left && side(c) >= -1e-12;
          if (all_left && side(q) < 0) is_inside = false;
        }
      }
      mask.at(column, row) = is_inside;
    }
  }
  return mask;
}

TEST(TriangleQuadtrees, HaveTheTrianglesOfOctant5InFigure9) {
  const TriangleQuadtrees trees(octant_hexagon(*find_view("corner-7"), 5, 256));
  const auto part_share = [&](int major, int label) {
    return trees.black_share(trees.part(trees.root(major), label));
  };
  for (const int label : {0, 1, 3}) EXPECT_NEAR(part_share(0, label), 1, 0.02) << label;
  for (const int label : {0, 1, 2}) EXPECT_NEAR(part_share(1, label), 1, 0.02) << label;
  EXPECT_NEAR(part_share(0, 2), 0, 0.02);
  EXPECT_NEAR(part_share(1, 3), 0, 0.02);
  for (int major = 2; major < 6; ++major) {
    EXPECT_NEAR(trees.black_share(trees.root(major)), 0, 0.02) << major;
  }
}

TEST(TriangleQuadtrees, AreDividedUntilNeighboursAreAPixelApart) {
  // sqrt(2) / 3 of the cube's side, halved until at most sqrt(2) / 4: once.
  Mask mask(4, 4);
  mask.at(1, 0) = 1;
  const TriangleQuadtrees trees(mask);
  for (int major = 0; major < 6; ++major) {
    for (int label = 0; label < 4; ++label) {
      const auto part = trees.part(trees.root(major), label);
      EXPECT_EQ(trees.part(part, 0), part);
    }
  }
}

TEST(CornerTree, FindsEveryOctantInEveryView) {
  for (const View& view : all_views()) {
    if (view.kind != ViewKind::Corner) continue;
    for (int octant = 0; octant < 8; ++octant) {
      NodePool pool(no_limit);
      SilhouetteRules rules;
      rules.max_depth = 4;
      const ColouredNode* const root =
          build_view_tree(view, octant_hexagon(view, octant, 128), rules, pool);
      EXPECT_EQ(child_of(root, octant), kBlack) << view.name << " " << octant;
      // The one on the other side of the cube's middle is hidden by it or has no part in it.
      const bool is_on_axis = std::abs(dot(view.towards_viewer, towards_octant(octant))) == 3;
      EXPECT_EQ(child_of(root, 7 - octant) == kBlack, is_on_axis) << view.name << " " << octant;
    }
  }
}

}  // namespace
}  // namespace spoctree
