// Sheets in first-angle and third-angle projection: ISO 128-30 and ISO 5456-2 say where views go.

#include "client/draw/arrange_views.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "client/draw/sheet.hpp"
#include "common/base/errors.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree::test {
namespace {

using Cells = std::vector<SheetCell>;

const std::vector<std::string> kAll = {"front", "back", "left", "right", "top", "bottom", "iso"};

TEST(ArrangeViews, FirstAnglePutsEachViewOppositeToItsSide) {
  //          bottom
  //  right   front   left   back
  //          top     iso
  EXPECT_EQ(arrange_views(kAll, Projection::FirstAngle),
            (Cells{{1, 1}, {3, 1}, {2, 1}, {0, 1}, {1, 2}, {1, 0}, {2, 2}}));
}

TEST(ArrangeViews, ThirdAnglePutsEachViewOnItsSide) {
  //          top     iso
  //  left    front   right  back
  //          bottom
  EXPECT_EQ(arrange_views(kAll, Projection::ThirdAngle),
            (Cells{{1, 1}, {3, 1}, {0, 1}, {2, 1}, {1, 0}, {1, 2}, {2, 0}}));
}

TEST(ArrangeViews, LeaveNoEmptyColumnsAndRows) {
  EXPECT_EQ(arrange_views({"top", "front"}, Projection::FirstAngle), (Cells{{0, 1}, {0, 0}}));
  EXPECT_EQ(arrange_views({"top", "front"}, Projection::ThirdAngle), (Cells{{0, 0}, {0, 1}}));
  EXPECT_EQ(arrange_views({"left", "right"}, Projection::FirstAngle), (Cells{{1, 0}, {0, 0}}));
  EXPECT_EQ(arrange_views({"front", "back"}, Projection::ThirdAngle), (Cells{{0, 0}, {1, 0}}));
  EXPECT_EQ(arrange_views({"iso"}, Projection::FirstAngle), (Cells{{0, 0}}));
}

TEST(ArrangeViews, FindIsoAFreeCorner) {
  const auto iso = [](std::vector<std::string> names, Projection projection) {
    names.push_back("iso");
    return arrange_views(names, projection).back();
  };
  // In the classical sheet of three views the fourth quarter is free.
  EXPECT_EQ(iso({"front", "left", "top"}, Projection::FirstAngle), (SheetCell{1, 1}));
  EXPECT_EQ(iso({"front", "right", "top"}, Projection::FirstAngle), (SheetCell{0, 1}));
  EXPECT_EQ(iso({"front", "right", "top"}, Projection::ThirdAngle), (SheetCell{1, 0}));
  // None is: a column of its own, beside the view from above if there is one.
  EXPECT_EQ(iso({"front", "top"}, Projection::FirstAngle), (SheetCell{1, 1}));
  EXPECT_EQ(iso({"front"}, Projection::FirstAngle), (SheetCell{1, 0}));
}

TEST(ArrangeViews, NeverPutTwoInOneCell) {
  for (unsigned subset = 1; subset < 128; ++subset) {
    std::vector<std::string> names;
    for (unsigned k = 0; k < 7; ++k) {
      if ((subset >> k & 1) != 0) names.push_back(kAll[k]);
    }
    for (const Projection projection : {Projection::FirstAngle, Projection::ThirdAngle}) {
      Cells cells = arrange_views(names, projection);
      ASSERT_EQ(cells.size(), names.size());
      std::sort(cells.begin(), cells.end(), [](const SheetCell& a, const SheetCell& b) {
        return std::pair(a.row, a.column) < std::pair(b.row, b.column);
      });
      EXPECT_EQ(std::adjacent_find(cells.begin(), cells.end()), cells.end()) << subset;
    }
  }
}

/// The captions' left ends do not tell where pictures are; their lines do.
struct Box {
  Vec2 lower{1e9, 1e9};
  Vec2 upper{-1e9, -1e9};
};

/// The line from the model's lowest to its highest corner alone, in each of the views.
std::vector<Box> boxes_of(const std::vector<std::string>& names, Projection projection) {
  const Octree tree = tree_of(Voxels{2, [](int x, int y, int z) { return x + 2 * y + z < 5; }});
  ViewOptions options;
  options.named = names;
  options.projection = projection;
  std::vector<Picture> pictures;
  VisibleLine diagonal;
  diagonal.a = {-1, -1, -1};
  diagonal.b = {1, 0.5, 1};
  for (const View& view : make_views(options, tree)) {
    diagonal.source.level = static_cast<std::uint8_t>(pictures.size());
    pictures.push_back({view, {diagonal}});
  }
  SheetOptions sheet;
  sheet.symbol = projection;
  const Drawing drawing = make_sheet(pictures, tree.universe, sheet);
  std::vector<Box> boxes(names.size());
  for (const StrokeGroup& group : drawing.groups) {
    if (!group.source) continue;
    Box& box = boxes[group.source->level];
    for (const Vec2 point : group.points) {
      box.lower = glm::min(box.lower, point);
      box.upper = glm::max(box.upper, point);
    }
  }
  return boxes;
}

TEST(ArrangeViews, ViewsOfASheetHaveCommonAxes) {
  for (const Projection projection : {Projection::FirstAngle, Projection::ThirdAngle}) {
    const auto boxes = boxes_of(kAll, projection);
    const Box& front = boxes[0];
    for (const std::size_t beside : {1, 2, 3}) {
      EXPECT_NEAR(boxes[beside].lower.y, front.lower.y, 1e-9) << beside;
      EXPECT_NEAR(boxes[beside].upper.y, front.upper.y, 1e-9) << beside;
    }
    for (const std::size_t in_line : {4, 5}) {
      EXPECT_NEAR(boxes[in_line].lower.x, front.lower.x, 1e-9) << in_line;
      EXPECT_NEAR(boxes[in_line].upper.x, front.upper.x, 1e-9) << in_line;
    }
    const bool is_first = projection == Projection::FirstAngle;
    EXPECT_EQ(boxes[2].lower.x > front.upper.x, is_first);
    EXPECT_EQ(boxes[3].upper.x < front.lower.x, is_first);
    EXPECT_EQ(boxes[4].lower.y > front.upper.y, is_first);
    EXPECT_EQ(boxes[5].upper.y < front.lower.y, is_first);
    EXPECT_GT(boxes[1].lower.x, std::max(boxes[2].upper.x, boxes[3].upper.x));
  }
}

TEST(ProjectionSymbol, IsAConeBesideItsSmallEnd) {
  for (const Projection projection : {Projection::FirstAngle, Projection::ThirdAngle}) {
    const auto strokes = projection_symbol(projection, {100, 50}, 8);
    const auto& cone = strokes.at(0);
    const auto& circle = strokes.at(1);
    // The small end is on the left; seen from there it is on the right of the cone in first-angle
    // projection, on the left in third-angle projection.
    EXPECT_EQ(cone[0].x < cone[1].x, true);
    EXPECT_NEAR(cone[3].y - cone[0].y, 4, 1e-12);
    EXPECT_NEAR(cone[2].y - cone[1].y, 8, 1e-12);
    EXPECT_EQ(circle[0].x > cone[0].x, projection == Projection::FirstAngle);
    for (const auto& stroke : strokes) {
      for (const Vec2 point : stroke) {
        EXPECT_TRUE(point.y >= 50 - 1e-9 && point.y <= 58 + 1e-9);
        EXPECT_TRUE(point.x >= 100 - 1e-9 && point.x <= 100 + projection_symbol_width(8) + 1e-9);
      }
    }
  }
}

TEST(ProjectionSymbol, StaysOnASmallPage) {
  const View view{"front", Camera(Vec3{0, -1, 0}), {{-1, -1}, {1, 1}}, Ink::Black, false};
  const Picture picture{view, {}};
  SheetOptions options;
  options.symbol = Projection::FirstAngle;
  options.page.paper = PaperSize{20, 60};
  const Drawing drawing = make_sheet({&picture, 1}, Universe{}, options);
  for (const StrokeGroup& group : drawing.groups) {
    for (const Vec2 point : group.points) {
      EXPECT_TRUE(point.x > 0 && point.x < 20);
      EXPECT_TRUE(point.y > 0 && point.y < 60);
    }
  }
}

TEST(ArrangeViews, RefuseWhatIsNoSheet) {
  const auto refuse = [](std::vector<std::string> names, bool has_projection) {
    ViewOptions options;
    options.named = std::move(names);
    if (has_projection) options.projection = Projection::ThirdAngle;
    EXPECT_THROW(check(options), UsageError);
  };
  refuse({}, true);
  refuse({"front"}, true);
  refuse({"front", "iso"}, true);
  refuse({"front", "top", "front"}, false);
  refuse({"front", ""}, false);
}

}  // namespace
}  // namespace spoctree::test
