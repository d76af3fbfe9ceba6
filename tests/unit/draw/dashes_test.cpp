// Dashes that run on along chains of hidden lines, in every format.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "client/draw/chain_lines.hpp"
#include "client/draw/cut_dashes.hpp"
#include "client/draw/sheet.hpp"
#include "client/draw/write_dxf.hpp"
#include "client/draw/write_hpgl.hpp"
#include "client/draw/write_pdf.hpp"
#include "client/draw/write_png.hpp"
#include "client/draw/write_svg.hpp"
#include "common/base/errors.hpp"
#include "tests/unit/draw/read_back.hpp"
#include "tests/unit/draw/sample_drawing.hpp"

namespace spoctree::test {
namespace {

const Camera kTop(Vec3{0, 0, 1});

VisibleLine hidden_line(Vec3 a, Vec3 b) {
  VisibleLine line;
  line.a = a;
  line.b = b;
  line.hidden = true;
  return line;
}

/// A circle around (0, 0) as `sides` lines, some of them turned round, in any order; and a spoke at
/// each corner.
VisibleLines wheel(int sides, double radius, double rim) {
  const auto corner = [&](int k, double r) {
    const double angle = 2 * std::acos(-1.0) * (k % sides) / sides;
    return Vec3{r * std::cos(angle), r * std::sin(angle), 0};
  };
  VisibleLines lines;
  for (int k = 0; k < sides; ++k) {
    lines.push_back(hidden_line(corner(k, radius), corner(k + 1, radius)));
    if (k % 3 == 0) std::swap(lines.back().a, lines.back().b);
    if (rim > radius) lines.push_back(hidden_line(corner(k, radius), corner(k, rim)));
  }
  std::shuffle(lines.begin(), lines.end(), std::mt19937(7));
  return lines;
}

Picture picture_of(const VisibleLines& lines, double half) {
  return make_picture({"", kTop, {{-half, -half}, {half, half}}, Ink::Black, false}, lines);
}

/// At 1 mm per unit.
Drawing drawing_of(const VisibleLines& lines, LineData data) {
  const Picture picture = picture_of(lines, 30);
  SheetOptions options;
  options.page.scale = 1;
  options.data = data;
  return make_sheet({&picture, 1}, Universe{}, options);
}

std::size_t strokes_of(const Drawing& drawing) {
  std::size_t count = 0;
  for (const StrokeGroup& group : drawing.groups) count += group.strokes.size();
  return count;
}

TEST(Chains, GoRoundACircleWhateverMeetsItThere) {
  const VisibleLines lines = wheel(24, 10, 20);
  const VisibleLines chained = in_chains(lines, kTop, 1e-9);
  ASSERT_EQ(chained.size(), lines.size());
  const auto is_rim = [](const VisibleLine& line) {
    return std::abs(glm::length(line.a) - glm::length(line.b)) < 1;
  };
  const auto first = std::find_if(chained.begin(), chained.end(), is_rim);
  ASSERT_GE(chained.end() - first, 24);
  EXPECT_TRUE(std::all_of(first, first + 24, is_rim));
  for (auto line = first + 1; line != first + 24; ++line)
    EXPECT_LT(glm::distance(line[-1].b, line->a), 1e-9);
}

TEST(Chains, KeepEveryLineOnce) {
  std::mt19937 random(1);
  VisibleLines lines;
  // On a small grid, so that many meet at a point, some lie on each other, and circles close.
  while (lines.size() < 400) {
    const auto any = [&] { return Vec3{double(random() % 6), double(random() % 6), 0}; };
    const VisibleLine line = hidden_line(any(), any());
    if (line.a != line.b) lines.push_back(line);
  }
  const auto keys_of = [](const VisibleLines& some) {
    std::vector<std::array<double, 4>> keys;
    for (const VisibleLine& line : some) {
      std::array<double, 2> a{line.a.x, line.a.y};
      std::array<double, 2> b{line.b.x, line.b.y};
      if (b < a) std::swap(a, b);
      keys.push_back({a[0], a[1], b[0], b[1]});
    }
    std::sort(keys.begin(), keys.end());
    return keys;
  };
  EXPECT_EQ(keys_of(in_chains(lines, kTop, 1e-9)), keys_of(lines));
  EXPECT_TRUE(in_chains({}, kTop, 1e-9).empty());
}

TEST(Chains, TurnWhatLinesKnowOfTheirStretchesToo) {
  VisibleLine backwards = hidden_line({2, 0, 0}, {1, 0, 0});
  backwards.stretches = {{0.25, {NodeKind::Convex, 1, false}, {}},
                         {1, {NodeKind::Concave, 2, false}, {}}};
  const VisibleLines chained =
      in_chains({hidden_line({0, 0, 0}, {1, 0, 0}), backwards}, kTop, 1e-9);
  ASSERT_EQ(chained.size(), 2U);
  const VisibleLine& turned = chained[0].a.x + chained[0].b.x > 2 ? chained[0] : chained[1];
  ASSERT_EQ(turned.stretches.size(), 2U);
  const bool is_turned = turned.a.x < turned.b.x;
  EXPECT_EQ(turned.stretches[0].source.level, is_turned ? 2 : 1);
  EXPECT_EQ(turned.stretches[0].end, is_turned ? 0.75 : 0.25);
}

TEST(CutDashes, BeginWithADashAndGoRoundCorners) {
  const std::vector<Vec2> corner = {{0, 0}, {4, 0}, {4, 4}};
  const auto dashes = cut_dashes(corner, 0, 3, 2);
  ASSERT_EQ(dashes.size(), 2U);
  EXPECT_EQ(dashes[0], (std::vector<Vec2>{{0, 0}, {3, 0}}));
  EXPECT_EQ(dashes[1], (std::vector<Vec2>{{4, 1}, {4, 4}}));
  const auto shifted = cut_dashes(corner, 5 * 7 + 4.5, 3, 2);
  ASSERT_EQ(shifted.size(), 2U);
  EXPECT_EQ(shifted[0], (std::vector<Vec2>{{0.5, 0}, {3.5, 0}}));
  EXPECT_EQ(shifted[1], (std::vector<Vec2>{{4, 1.5}, {4, 4}}));
  const auto round = cut_dashes(corner, 3.5, 3, 2);
  ASSERT_EQ(round.size(), 2U);
  EXPECT_EQ(round[0], (std::vector<Vec2>{{1.5, 0}, {4, 0}, {4, 0.5}}));
}

TEST(CutDashes, AreAsLongInAllAsTheyShouldBeHoweverTheLineIsDivided) {
  std::vector<Vec2> points;
  for (int k = 0; k <= 2600; ++k) points.push_back({0.01 * k, 0});
  double length = 0;
  for (const auto& dash : cut_dashes(points, 0, 1.6, 1.0))
    length += glm::distance(dash.front(), dash.back());
  EXPECT_NEAR(length, 16, 1e-9);
}

// 240 lines of 0.52 mm: each would be one dash if dashes began anew.
TEST(Dashes, RunOnAlongATessellatedCircle) {
  const VisibleLines circle = wheel(240, 20, 0);
  const double side = 2 * 20 * std::sin(std::acos(-1.0) / 240);
  const Drawing bare = drawing_of(circle, LineData::None);
  EXPECT_EQ(strokes_of(bare), 1U);
  const Drawing known = drawing_of(circle, LineData::Planes);
  ASSERT_EQ(strokes_of(known), 240U);
  for (std::size_t k = 0; k < 240; ++k)
    EXPECT_NEAR(known.groups[0].strokes[k].dashes_before_mm, static_cast<double>(k) * side, 1e-6);
  const double around = 240 * side;
  const double share = kDashMm / (kDashMm + kDashGapMm);
  for (const Drawing& drawing : {bare, known}) {
    double inked = 0;
    for (const Segment& segment : read_hpgl(to_hpgl(drawing)))
      inked += glm::distance(segment.a, segment.b);
    EXPECT_NEAR(inked, share * around, 0.02 * around);
  }
}

// A staircase, whose treads and risers are of two sources.
TEST(Dashes, RunOnWhereTheSourceChanges) {
  VisibleLines lines;
  for (int k = 0; k < 5; ++k) {
    lines.push_back(hidden_line({k, k, 0}, {k + 1, k, 0}));
    lines.back().source = {NodeKind::Convex, 2, false};
    lines.push_back(hidden_line({k + 1, k, 0}, {k + 1, k + 1, 0}));
    lines.back().source = {NodeKind::Concave, 2, false};
  }
  const Drawing drawing = drawing_of(lines, LineData::Source);
  ASSERT_EQ(drawing.groups.size(), 2U);
  for (const StrokeGroup& group : drawing.groups) {
    ASSERT_EQ(group.strokes.size(), 5U);
    for (const Stroke& stroke : group.strokes) {
      const Vec2 from_start = group.points_of(stroke)[0] - Vec2{35, 35};
      EXPECT_NEAR(stroke.dashes_before_mm, from_start.x - from_start.y, 1e-9);
    }
  }
}

TEST(Dashes, BeginAnewWhereTheLineDoes) {
  const Drawing drawing = drawing_of(
      {hidden_line({0, 0, 0}, {3, 0, 0}), hidden_line({3, 1, 0}, {0, 1, 0})}, LineData::Planes);
  for (const Stroke& stroke : drawing.groups.at(0).strokes) EXPECT_EQ(stroke.dashes_before_mm, 0);
}

TEST(Dashes, OfVisibleLinesAreNone) {
  VisibleLines lines = wheel(12, 10, 0);
  for (VisibleLine& line : lines) line.hidden = false;
  const Drawing drawing = drawing_of(lines, LineData::Planes);
  for (const Stroke& stroke : drawing.groups.at(0).strokes) EXPECT_EQ(stroke.dashes_before_mm, 0);
}

/// Two hidden strokes, the second one 5 mm into the dashes.
Drawing two_strokes() {
  Drawing drawing;
  drawing.width_mm = drawing.height_mm = 50;
  Pen hidden;
  hidden.hidden = true;
  drawing.groups.push_back(group_of(hidden, {{{10, 10}, {15, 10}}, {{15, 10}, {15, 20}}}));
  drawing.groups[0].strokes[1].dashes_before_mm = 5;
  return drawing;
}

TEST(Dashes, AreOffsetsInSvg) {
  Drawing drawing = two_strokes();
  for (const bool has_source : {false, true}) {
    if (has_source) drawing.groups[0].source = LineSource{};
    const std::string svg = to_svg(drawing);
    EXPECT_TRUE(is_well_formed_xml(svg));
    EXPECT_EQ(svg.find("stroke-dashoffset"), svg.rfind("stroke-dashoffset=\"5\" d=\"M15 10v10\""));
    EXPECT_EQ(read_svg(svg).size(), 2U);
  }
}

TEST(Dashes, ArePhasesInPdf) {
  PdfWriter writer;
  writer.add_page(two_strokes());
  std::string content;
  for (const std::string& object : read_pdf_objects(writer.finish("")).objects) content += object;
  // 5 = 1.6 + 1 + 2.4
  EXPECT_NE(content.find("[1.6 1] 0 d\n10 10 m\n15 10 l\nS\n[1.6 1] 2.4 d\n15 10 m\n"),
            std::string::npos);
}

TEST(Dashes, OfPngAreWhereTheOffsetSays) {
  Drawing drawing = two_strokes();
  drawing.groups[0].strokes[1].dashes_before_mm = kDashMm + kDashGapMm;
  const std::string whole_period = to_png(drawing, 100);
  drawing.groups[0].strokes[1].dashes_before_mm = 0;
  EXPECT_EQ(to_png(drawing, 100), whole_period);
  drawing.groups[0].strokes[1].dashes_before_mm = 1.3;
  EXPECT_NE(to_png(drawing, 100), whole_period);
}

TEST(Dashes, AreCutInHpgl) {
  const auto dashes = read_hpgl(to_hpgl(two_strokes()));
  // 0 to 1.6 and 2.6 to 4.2 of the first; the second begins 2.4 into the pattern, with 0.2 of gap.
  ASSERT_EQ(dashes.size(), 6U);
  EXPECT_NEAR(dashes[0].a.x, 10, 0.0126);
  EXPECT_NEAR(dashes[0].b.x, 11.6, 0.0126);
  EXPECT_NEAR(dashes[1].b.x, 14.2, 0.0126);
  EXPECT_NEAR(dashes[2].a.y, 40 - 0.2, 0.0126);
  EXPECT_NEAR(dashes[2].b.y, 40 - 1.8, 0.0126);
  EXPECT_NEAR(dashes[5].b.y, 40 - 9.6, 0.0126);
  EXPECT_EQ(to_hpgl(two_strokes()).find("LT"), std::string::npos);
}

TEST(Dashes, AreNotMadeByTheMillionsInHpgl) {
  Drawing drawing = two_strokes();
  drawing.width_mm = drawing.height_mm = 200'000;
  for (int k = 0; k < 200; ++k) {
    StrokeGroup& group = drawing.groups[0];
    group.points.insert(group.points.end(), {{0, 0}, {200'000, 200'000}});
    const auto size = static_cast<std::uint32_t>(group.points.size());
    group.strokes.push_back({size - 2, size, {}, 0});
  }
  EXPECT_THROW(to_hpgl(drawing), UsageError);
}

TEST(Dashes, GoRoundTheCornersOfDxfPolylines) {
  Drawing drawing = drawing_of(wheel(12, 10, 0), LineData::None);
  int generated = 0;
  std::string kind;
  for (const auto& [code, value] : read_dxf_pairs(to_dxf(drawing))) {
    if (code == 0) kind = value;
    if (kind == "POLYLINE" && code == 70) generated = std::stoi(value);
  }
  EXPECT_EQ(generated, 128);
}

}  // namespace
}  // namespace spoctree::test
