#include "client/draw/sheet.hpp"

#include <gtest/gtest.h>

#include "client/draw/lettering.hpp"
#include "common/base/errors.hpp"

namespace spoctree::test {
namespace {

VisibleLine line(Vec3 a, Vec3 b, LineKind kind = LineKind::Crease) {
  return {a, b, kind, false, false, {}, {}, {}};
}

Picture picture(const char* name, Vec3 from, Rectangle frame, const VisibleLines& lines) {
  return make_picture({name, Camera(from), frame, Ink::Black, false}, lines);
}

SheetOptions options(double longest_mm = 120, double margin_mm = 10) {
  SheetOptions result;
  result.page.longest_mm = longest_mm;
  result.page.margin_mm = margin_mm;
  result.data = LineData::None;
  return result;
}

void expect_near(Vec2 point, Vec2 expected) {
  EXPECT_NEAR(point.x, expected.x, 1e-9);
  EXPECT_NEAR(point.y, expected.y, 1e-9);
}

TEST(Sheet, FitsTheFrameBetweenTheMargins) {
  const Picture front =
      picture("", {0, -1, 0}, {{-1, -0.5}, {1, 0.5}}, {line({-1, 0, -0.5}, {1, 0, 0.5})});
  const Drawing drawing = make_sheet({&front, 1}, Universe{}, options());
  EXPECT_DOUBLE_EQ(drawing.width_mm, 120);
  EXPECT_DOUBLE_EQ(drawing.height_mm, 70);
  ASSERT_EQ(drawing.groups.size(), 1U);
  const auto points = drawing.groups[0].points_of(drawing.groups[0].strokes[0]);
  // Left and below is at the left margin and at the foot of the page.
  expect_near(points[0], {10, 60});
  expect_near(points[1], {110, 10});
}

TEST(Sheet, ScalesInMillimetresPerModelUnit) {
  Universe universe;
  universe.scale_exponent = 4;  // 16 model units per unit
  const Picture front = picture("", {0, -1, 0}, {{-1, -0.5}, {1, 0.5}}, {});
  SheetOptions half = options();
  half.page.scale = 0.5;
  const Drawing drawing = make_sheet({&front, 1}, universe, half);
  EXPECT_DOUBLE_EQ(drawing.width_mm, 2 * 16 * 0.5 + 20);
  EXPECT_DOUBLE_EQ(drawing.height_mm, 16 * 0.5 + 20);
  EXPECT_DOUBLE_EQ(drawing.scale, 0.5);
}

TEST(Sheet, TurnsNamedPaperToFitAndCentres) {
  const Picture front = picture("", {0, -1, 0}, {{-2, -1}, {2, 1}}, {line({-2, 0, 1}, {2, 0, 1})});
  SheetOptions a4 = options();
  parse_paper("A4", a4.page);
  const Drawing drawing = make_sheet({&front, 1}, Universe{}, a4);
  EXPECT_DOUBLE_EQ(drawing.width_mm, 297);
  EXPECT_DOUBLE_EQ(drawing.height_mm, 210);
  const double half_height = 0.5 * (297 - 20) / 2;
  expect_near(drawing.groups[0].points[0], {10, 105 - half_height});
}

TEST(Sheet, MakesOneStrokeOfLinesThatFollowEachOther) {
  const Picture top =
      picture("", {0, 0, 1}, {{0, 0}, {1, 1}},
              {line({0, 0, 0}, {1, 0, 0}), line({1, 0, 0}, {1, 1, 0}), line({0, 1, 0}, {0.5, 1, 0}),
               line({0, 0, 0}, {0.5, 0, 0}, LineKind::Silhouette)});
  const Drawing drawing = make_sheet({&top, 1}, Universe{}, options());
  ASSERT_EQ(drawing.groups.size(), 2U);
  ASSERT_EQ(drawing.groups[0].strokes.size(), 2U);
  EXPECT_EQ(drawing.groups[0].points_of(drawing.groups[0].strokes[0]).size(), 3U);
  EXPECT_EQ(drawing.groups[0].points_of(drawing.groups[0].strokes[1]).size(), 2U);
  EXPECT_EQ(drawing.groups[1].strokes.size(), 1U);
}

TEST(Sheet, JoinsWhatGoesStraightOnInThePicture) {
  // Seen from above, the second line starts where the first one ends, and goes on; then a corner.
  const Picture top =
      picture("", {0, 0, 1}, {{0, 0}, {3, 3}},
              {line({0, 0, 0}, {1, 0, 0}), line({1, 0, 7}, {2, 0, 9}), line({2, 0, 1}, {2, 1, 1})});
  const Drawing drawing = make_sheet({&top, 1}, Universe{}, options());
  ASSERT_EQ(drawing.groups[0].strokes.size(), 1U);
  const auto points = drawing.groups[0].points_of(drawing.groups[0].strokes[0]);
  ASSERT_EQ(points.size(), 3U);
  expect_near(points[1], {10 + 200.0 / 3, 110});
}

TEST(Sheet, WithDataEveryLineIsAStrokeOfItsSource) {
  VisibleLine convex = line({0, 0, 0}, {1, 0, 0});
  convex.source = {NodeKind::Convex, 2, true};
  convex.planes[0] = PlaneRef::of_table(5);
  VisibleLine grey = line({1, 0, 0}, {1, 1, 0});
  const Picture top = picture("", {0, 0, 1}, {{0, 0}, {1, 1}}, {convex, grey});
  SheetOptions with_data = options();
  with_data.data = LineData::Planes;
  with_data.colour_by_kind = true;
  const Drawing drawing = make_sheet({&top, 1}, Universe{}, with_data);
  ASSERT_EQ(drawing.groups.size(), 2U);
  EXPECT_EQ(drawing.groups[0].pen.ink, Ink::Grey);
  EXPECT_EQ(drawing.groups[1].pen.ink, Ink::Red);
  EXPECT_EQ(drawing.groups[1].source, convex.source);
  const auto planes = drawing.groups[1].planes_of(drawing.groups[1].strokes[0]);
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(planes[0][0], PlaneRef::of_table(5));
}

TEST(Sheet, CutsNoSideOfAClosedOutline) {
  // A square whose lower side is two lines; the first of all lines is in its middle.
  const Picture top =
      picture("", {0, 0, 1}, {{0, 0}, {2, 2}},
              {line({1, 0, 0}, {2, 0, 0}), line({2, 0, 0}, {2, 2, 0}), line({2, 2, 0}, {0, 2, 0}),
               line({0, 2, 0}, {0, 0, 0}), line({0, 0, 0}, {1, 0, 0})});
  SheetOptions bare = options();
  bare.data = LineData::None;
  const Drawing outline = make_sheet({&top, 1}, Universe{}, bare);
  ASSERT_EQ(outline.groups[0].strokes.size(), 1U);
  EXPECT_EQ(outline.groups[0].points.size(), 5U);  // back where it began
  SheetOptions with_data = options();
  with_data.data = LineData::Planes;
  EXPECT_EQ(make_sheet({&top, 1}, Universe{}, with_data).groups[0].strokes.size(), 4U);
}

// Where a line ends at the middle of another one, that is still one line.
TEST(Sheet, DoesNotTurnOffWhereALineGoesOn) {
  const Picture top =
      picture("", {0, 0, 1}, {{0, 0}, {2, 1}},
              {line({0, 0, 0}, {1, 0, 0}), line({1, 0, 0}, {1, 1, 0}), line({1, 0, 1}, {2, 0, 1})});
  for (const LineData data : {LineData::None, LineData::Source, LineData::Planes}) {
    SheetOptions any = options();
    any.data = data;
    const Drawing drawing = make_sheet({&top, 1}, Universe{}, any);
    ASSERT_EQ(drawing.groups.size(), 1U);
    EXPECT_EQ(drawing.groups[0].strokes.size(), 2U);
    for (const Stroke& stroke : drawing.groups[0].strokes)
      EXPECT_EQ(drawing.groups[0].points_of(stroke).size(), 2U);
  }
}

// A draughtsman draws one line where edges at different depths go on behind each other.
TEST(Sheet, WithDataAStraightLineOfThePictureIsAStrokeThatKnowsAllItsStretches) {
  const auto pair = [](std::uint32_t a, std::uint32_t b) {
    return PlanePair{PlaneRef::of_table(a), PlaneRef::of_table(b)};
  };
  VisibleLine near = line({0, 0, 5}, {1, 0, 5});
  near.source = {NodeKind::Convex, 2, false};
  near.planes[0] = pair(1, 2)[0];
  near.planes[1] = pair(1, 2)[1];
  VisibleLine far = line({1, 0, 0}, {3, 0, 0});
  far.source = {NodeKind::Concave, 4, false};
  far.stretches = {{0.5, far.source, {PlaneRef::of_table(1), PlaneRef::of_table(2)}},
                   {1, far.source, {PlaneRef::of_table(3), PlaneRef::of_table(2)}}};
  const VisibleLine corner = line({3, 0, 0}, {3, 1, 0});
  const Picture top = picture("", {0, 0, 1}, {{0, 0}, {3, 1}}, {near, far, corner});
  SheetOptions with_data = options();
  with_data.data = LineData::Planes;
  const Drawing drawing = make_sheet({&top, 1}, Universe{}, with_data);
  std::size_t strokes = 0;
  for (const StrokeGroup& group : drawing.groups) {
    strokes += group.strokes.size();
    if (group.source != far.source) continue;
    ASSERT_EQ(group.strokes.size(), 1U);
    const auto planes = group.planes_of(group.strokes[0]);
    EXPECT_EQ(std::vector(planes.begin(), planes.end()), (std::vector{pair(1, 2), pair(3, 2)}));
  }
  EXPECT_EQ(strokes, 2U);
}

TEST(Sheet, PutsPicturesSideBySideAtOneScaleWithCaptions) {
  const Picture pictures[] = {
      picture("front", {0, -1, 0}, {{0, 0}, {2, 1}}, {line({0, 0, 0}, {2, 0, 0})}),
      picture("right", {1, 0, 0}, {{0, 0}, {1, 1}}, {line({0, 0, 0}, {0, 1, 0})})};
  SheetOptions to_scale = options();
  to_scale.page.scale = 10;
  const Drawing drawing = make_sheet(pictures, Universe{}, to_scale);
  ASSERT_EQ(drawing.groups.size(), 2U);
  const StrokeGroup& creases = drawing.groups[0];
  ASSERT_EQ(creases.strokes.size(), 2U);
  // The front's foot is 20 mm long and 10 mm below the margin, the right one's 10 mm, level with it
  // and 8 mm aside.
  expect_near(creases.points[0], {10, 20});
  expect_near(creases.points[1], {30, 20});
  expect_near(creases.points[2], {38, 20});
  expect_near(creases.points[3], {48, 20});
  EXPECT_EQ(drawing.groups[1].pen.use, PenUse::Lettering);
  EXPECT_EQ(drawing.groups[1].strokes.size(),
            letter("front", {}, 1).size() + letter("right", {}, 1).size());
  for (const Vec2 point : drawing.groups[1].points) {
    EXPECT_GT(point.y, 20);
    EXPECT_LT(point.y, drawing.height_mm - 10 + 1e-9);
  }
}

TEST(Sheet, CutsLinesOffAtTheFrame) {
  const Picture front = picture("", {0, -1, 0}, {{-1, -1}, {1, 1}},
                                {line({-3, 0, 0}, {3, 0, 0}), line({2, 0, -3}, {2, 0, 3})});
  const Drawing drawing = make_sheet({&front, 1}, Universe{}, options(120, 10));
  ASSERT_EQ(drawing.groups[0].strokes.size(), 1U);
  EXPECT_NEAR(drawing.groups[0].points[0].x, 10, 1e-6);
  EXPECT_NEAR(drawing.groups[0].points[1].x, 110, 1e-6);
}

TEST(Sheet, CutsOffWhatIsBehindAnEye) {
  Picture inside = picture("", {0, 0, 1}, {{-1, -1}, {1, 1}}, {});
  inside.view.camera = Camera::perspective({0, 0, 0}, {0, 1, 0});
  // From (1, 2, 0), which is seen half way to the right, to behind the eye.
  inside =
      make_picture(inside.view, {line({1, 2, 0}, {1, -5, 0}), line({0.5, -1, 0}, {0.5, -9, 0})});
  const Drawing drawing = make_sheet({&inside, 1}, Universe{}, options(120, 10));
  ASSERT_EQ(drawing.groups[0].strokes.size(), 1U);
  EXPECT_NEAR(drawing.groups[0].points[0].x, 60 + 25, 1e-6);
  EXPECT_NEAR(drawing.groups[0].points[1].x, 110, 1e-6);
}

TEST(Sheet, RejectsAPageWithoutRoom) {
  const Picture flat = picture("", {0, 0, 1}, {{0, 0}, {0, 1}}, {});
  EXPECT_THROW(make_sheet({&flat, 1}, Universe{}, options()), UsageError);
  const Picture square = picture("", {0, 0, 1}, {{0, 0}, {1, 1}}, {});
  for (const double margin : {60.0, -1.0, std::nan("")})
    EXPECT_THROW(make_sheet({&square, 1}, Universe{}, options(120, margin)), UsageError);
  SheetOptions too_large = options();
  parse_paper("100x100", too_large.page);
  too_large.page.scale = 81;
  EXPECT_THROW(make_sheet({&square, 1}, Universe{}, too_large), UsageError);
  too_large.page.scale = 80;
  EXPECT_NO_THROW(make_sheet({&square, 1}, Universe{}, too_large));
}

TEST(Sheet, RejectsAScaleThatLeavesNothingToSee) {
  const Picture square = picture("", {0, 0, 1}, {{0, 0}, {1, 1}}, {});
  SheetOptions tiny = options();
  tiny.page.scale = 0.11;
  EXPECT_NO_THROW(make_sheet({&square, 1}, Universe{}, tiny));
  tiny.page.scale = 0.09;
  EXPECT_THROW(make_sheet({&square, 1}, Universe{}, tiny), UsageError);
  tiny.page.least_mm = 0;
  EXPECT_NO_THROW(make_sheet({&square, 1}, Universe{}, tiny));
}

TEST(Page, ReadsScalesAndPapers) {
  EXPECT_DOUBLE_EQ(parse_scale("1:50"), 0.02);
  EXPECT_DOUBLE_EQ(parse_scale("2:1"), 2);
  EXPECT_DOUBLE_EQ(parse_scale("0.5"), 0.5);
  for (const char* bad :
       {"", "0", "-1", "1:0", "1:-2", ":", "1:2:3", "nan", "1e999", "1e-300:1e300"})
    EXPECT_THROW(parse_scale(bad), UsageError) << bad;
  PageOptions page;
  parse_paper("210x99.5", page);
  EXPECT_DOUBLE_EQ(page.paper->height_mm, 99.5);
  EXPECT_FALSE(page.may_turn_paper);
  for (const char* bad : {"", "A7", "B4", "x", "10x", "10x0", "A44", "10x10x10"})
    EXPECT_THROW(parse_paper(bad, page), UsageError) << bad;
}

TEST(Lettering, StaysInItsBox) {
  for (const char* text : {"ABCDEFGHIJKLMNOPQRSTUVWXYZ", "abcdefghijklm", "0123456789-./:,"}) {
    const double width = lettering_width(text, 6);
    for (const auto& stroke : letter(text, {100, 50}, 6)) {
      EXPECT_GE(stroke.size(), 2U) << text;
      for (const Vec2 point : stroke) {
        EXPECT_TRUE(point.x >= 100 && point.x <= 100 + width) << text;
        EXPECT_TRUE(point.y >= 44 && point.y <= 50) << text;
      }
    }
  }
  EXPECT_TRUE(letter(" <\xC3\xA4>", {}, 6).empty());
}

}  // namespace
}  // namespace spoctree::test
