// Every format of a page, read back by readers of their own: the same segments.

#include <gtest/gtest.h>

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

struct Expected {
  Vec2 a;
  Vec2 b;
  std::string layer;
};

bool is_near(Vec2 p, Vec2 q, double tolerance) {
  return std::abs(p.x - q.x) <= tolerance && std::abs(p.y - q.y) <= tolerance;
}

void expect_segments(const std::vector<Segment>& found, const std::vector<Expected>& expected,
                     double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_TRUE(is_near(found[k].a, expected[k].a, tolerance)) << k;
    EXPECT_TRUE(is_near(found[k].b, expected[k].b, tolerance)) << k;
    EXPECT_EQ(found[k].layer, expected[k].layer) << k;
  }
}

Drawing drawing_of(std::initializer_list<std::vector<Vec2>> creases) {
  Drawing drawing;
  drawing.width_mm = 100;
  drawing.height_mm = 50;
  drawing.groups.push_back(group_of({}, creases));
  return drawing;
}

TEST(Svg, HoldsTheSegmentsWithTheirClassesAndPlanes) {
  const std::string svg = to_svg(sample_drawing());
  const auto segments = read_svg(svg);
  expect_segments(segments,
                  {{{90, 60}, {90, 10}, "crease hidden"},
                   {{1, 2}, {3.5, 4.25}, "crease"},
                   {{10, 2}, {5, 2}, "crease"},
                   {{20, 20}, {30, 20}, "silhouette"},
                   {{30, 20}, {30, 45}, "silhouette"}},
                  1e-12);
  EXPECT_EQ(segments[1].data, "7 12");
  EXPECT_EQ(segments[2].data, "x=2.5 0, 3 0");
  EXPECT_NE(svg.find("data-node=\"convex\" data-level=\"3\""), std::string::npos);
}

TEST(ReadBack, TellsMarkupThatIsNotWellFormed) {
  EXPECT_TRUE(is_well_formed_xml("<a b=\"1\" c-d=\"\"><e/>text<f\ng=\"2\"/></a>"));
  for (const char* bad : {"<a>", "<a></b>", "</a>", "<a b=1/>", "<a b=\"1/>", "<a b=\"<\"/>",
                          "<a b/>", "<a><b></a></b>", "<>", "<a", "1 < 2"})
    EXPECT_FALSE(is_well_formed_xml(bad)) << bad;
}

TEST(Svg, IsWellFormedAndInMillimetres) {
  const std::string svg = to_svg(sample_drawing());
  EXPECT_TRUE(is_well_formed_xml(svg));
  EXPECT_NE(svg.find("width=\"100mm\" height=\"62.5mm\" viewBox=\"0 0 100 62.5\""),
            std::string::npos);
}

TEST(Svg, RoundsToHundredthsWithoutDrift) {
  std::vector<Vec2> points;
  for (int k = 0; k <= 1000; ++k) points.push_back({0.0449 * k, 0.0151 * k});
  const auto segments = read_svg(to_svg(drawing_of({points})));
  EXPECT_TRUE(is_near(segments.back().b, {44.9, 15.1}, 0.005 + 1e-9));
}

TEST(Svg, LeavesOutWhatIsSmallerThanADot) {
  const auto segments =
      read_svg(to_svg(drawing_of({{{1, 1}, {1.001, 1.001}}, {{2, 2}, {2.001, 2}, {3, 2}}})));
  expect_segments(segments, {{{2, 2}, {3, 2}, "crease"}}, 1e-12);
}

TEST(Svg, EscapesTheTitle) {
  Drawing drawing = drawing_of({});
  drawing.title = "</title><script>\"&\n";
  const std::string svg = to_svg(drawing);
  EXPECT_TRUE(is_well_formed_xml(svg));
  EXPECT_NE(svg.find("<title>&lt;/title&gt;&lt;script&gt;&quot;&amp; </title>"), std::string::npos);
}

TEST(Dxf, HoldsTheSegmentsOnLayers) {
  const auto segments = read_dxf(to_dxf(sample_drawing()));
  expect_segments(segments,
                  {{{90, 2.5}, {90, 52.5}, "HIDDEN"},
                   {{1, 60.5}, {3.5, 58.25}, "CREASE_CONVEX_3"},
                   {{10, 60.5}, {5, 60.5}, "CREASE_CONVEX_3"},
                   {{20, 42.5}, {30, 42.5}, "SILHOUETTE"},
                   {{30, 42.5}, {30, 17.5}, "SILHOUETTE"}},
                  1e-9);
  EXPECT_EQ(segments[1].data, "7 12");
  EXPECT_EQ(segments[2].data, "x=2.5 0 3 0");
}

TEST(Dxf, DeclaresWhatItUses) {
  const auto pairs = read_dxf_pairs(to_dxf(sample_drawing()));
  EXPECT_EQ(pairs.back(), (std::pair<int, std::string>{0, "EOF"}));
  std::map<std::string, std::string> line_type_of_layer;
  int open_sections = 0;
  int open_tables = 0;
  std::string kind;
  std::string name;
  for (const auto& [code, value] : pairs) {
    if (code == 0) kind = value;
    if (code == 0 && value == "SECTION") ++open_sections;
    if (code == 0 && value == "ENDSEC") --open_sections;
    if (code == 0 && value == "TABLE") ++open_tables;
    if (code == 0 && value == "ENDTAB") --open_tables;
    if (code == 2) name = value;
    if (code == 6 && kind == "LAYER") line_type_of_layer[name] = value;
  }
  EXPECT_EQ(open_sections, 0);
  EXPECT_EQ(open_tables, 0);
  EXPECT_EQ(line_type_of_layer,
            (std::map<std::string, std::string>{{"0", "CONTINUOUS"},
                                                {"HIDDEN", "DASHED"},
                                                {"CREASE_CONVEX_3", "CONTINUOUS"},
                                                {"SILHOUETTE", "CONTINUOUS"}}));
}

TEST(Dxf, LayersHaveNamesThatR12Takes) {
  Drawing drawing;
  drawing.width_mm = drawing.height_mm = 10;
  for (const PenUse use : {PenUse::Crease, PenUse::Silhouette}) {
    for (const bool hidden : {false, true}) {
      for (int ink = 0; ink < kInkCount; ++ink) {
        StrokeGroup group =
            group_of({hidden, use, true, static_cast<Ink>(ink)}, {{{0, 0}, {1, 1}}});
        drawing.groups.push_back(group);
        group.source = LineSource{NodeKind::Concave, 30, true};
        drawing.groups.push_back(group);
      }
    }
  }
  std::map<std::string, int> declared;
  std::string kind;
  for (const auto& [code, value] : read_dxf_pairs(to_dxf(drawing))) {
    if (code == 0) kind = value;
    if (code == 2 && kind == "LAYER") ++declared[value];
    if (code != 8) continue;
    EXPECT_EQ(declared[value], 1) << value;
    EXPECT_LE(value.size(), 31U) << value;
    EXPECT_EQ(value.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"), std::string::npos);
  }
}

TEST(Hpgl, HoldsTheSegmentsWithAPenForEachClass) {
  auto segments = read_hpgl(to_hpgl(sample_drawing()));
  // The hidden line of 50 mm is twenty dashes, one each 2.6 mm; the last one is cut off.
  ASSERT_GT(segments.size(), 20U);
  for (int k = 0; k < 20; ++k) {
    const Segment& dash = segments[static_cast<std::size_t>(k)];
    EXPECT_TRUE(is_near(dash.a, {90, 2.5 + 2.6 * k}, 0.0126));
    EXPECT_TRUE(is_near(dash.b, {90, std::min(52.5, 4.1 + 2.6 * k)}, 0.0126));
    EXPECT_EQ(dash.layer, "4");
  }
  segments.erase(segments.begin(), segments.begin() + 20);
  expect_segments(segments,
                  {{{1, 60.5}, {3.5, 58.25}, "2"},
                   {{10, 60.5}, {5, 60.5}, "2"},
                   {{20, 42.5}, {30, 42.5}, "1"},
                   {{30, 42.5}, {30, 17.5}, "1"}},
                  0.0125 + 1e-12);
}

TEST(Hpgl, LiftsThePenOnlyWhereTheLineEnds) {
  const std::string hpgl =
      to_hpgl(drawing_of({{{0, 50}, {10, 50}}, {{10, 50}, {10, 40}}, {{10, 30}, {0, 30}}}));
  EXPECT_EQ(hpgl, "IN;\nSP2;\nPU0,0;PD400,0;\nPD400,400;\nPU400,800;PD0,800;\nPU;\nSP0;\n");
}

TEST(Hpgl, GoesToTheLinesBeginningWithAPenJustTaken) {
  Drawing drawing = drawing_of({{{0, 50}, {10, 50}}});
  Pen silhouette;
  silhouette.use = PenUse::Silhouette;
  drawing.groups.push_back(group_of(silhouette, {{{10, 50}, {10, 40}}}));
  EXPECT_NE(to_hpgl(drawing).find("SP1;\nPU400,0;PD400,400;\n"), std::string::npos);
}

TEST(Hpgl, RefusesAPageBeyondItsNumbers) {
  Drawing drawing = drawing_of({{{0, 0}, {1, 1}}});
  drawing.width_mm = 300'000;
  EXPECT_THROW(to_hpgl(drawing), UsageError);
}

TEST(Pdf, HoldsTheSegmentsOnLayersAtTrueScale) {
  PdfWriter writer;
  writer.add_page(sample_drawing());
  const auto pages = read_pdf(writer.finish("sample"));
  ASSERT_EQ(pages.size(), 1U);
  const double pt = 72 / 25.4;
  EXPECT_NEAR(pages[0].width, 100 * pt, 1e-5);
  EXPECT_NEAR(pages[0].height, 62.5 * pt, 1e-5);
  expect_segments(pages[0].segments,
                  {{Vec2{90, 2.5} * pt, Vec2{90, 52.5} * pt, "crease hidden"},
                   {Vec2{1, 60.5} * pt, Vec2{3.5, 58.25} * pt, "convex, level 3"},
                   {Vec2{10, 60.5} * pt, Vec2{5, 60.5} * pt, "convex, level 3"},
                   {Vec2{20, 42.5} * pt, Vec2{30, 42.5} * pt, "silhouette"},
                   {Vec2{30, 42.5} * pt, Vec2{30, 17.5} * pt, "silhouette"}},
                  1e-3);
}

TEST(Pdf, HasAnOutlineEntryForEachPage) {
  PdfWriter writer;
  for (const char* title : {"level 0", "level 1", "level \xE2\x82\xAC)"}) {
    Drawing drawing = sample_drawing();
    drawing.title = title;
    writer.add_page(drawing);
  }
  const std::string pdf = writer.finish("all");
  EXPECT_EQ(read_pdf(pdf).size(), 3U);
  // "level €)": a parenthesis ends nothing in a hexadecimal string.
  EXPECT_NE(pdf.find("/Title<FEFF006C006500760065006C002020AC0029>"), std::string::npos);
  std::size_t entries = 0;
  for (const std::string& object : read_pdf_objects(pdf).objects)
    entries += object.find("/Dest[") != std::string::npos ? 1U : 0U;
  EXPECT_EQ(entries, 3U);
  EXPECT_EQ(pdf.find("CreationDate"), std::string::npos);
}

TEST(Pdf, RefusesAPageBeyondItsLimit) {
  Drawing drawing = sample_drawing();
  drawing.width_mm = 5081;
  PdfWriter writer;
  EXPECT_THROW(writer.add_page(drawing), UsageError);
}

TEST(Png, HasTheSizeThatTheResolutionSays) {
  const std::string png = to_png(sample_drawing(), 254);  // 10 pixels per millimetre
  ASSERT_GT(png.size(), 24U);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  const auto number_at = [&](std::size_t at) {
    int number = 0;
    for (std::size_t k = 0; k < 4; ++k)
      number = number * 256 + static_cast<unsigned char>(png[at + k]);
    return number;
  };
  EXPECT_EQ(number_at(16), 1000);
  EXPECT_EQ(number_at(20), 625);
  // The chunk pHYs: 9 bytes, pixels per metre across and down, 1: metres.
  EXPECT_EQ(png.substr(33, 8), std::string("\0\0\0\x09pHYs", 8));
  EXPECT_EQ(number_at(41), 10000);
  EXPECT_EQ(number_at(45), 10000);
  EXPECT_EQ(png[49], '\1');
  EXPECT_EQ(png, to_png(sample_drawing(), 254));
}

TEST(Png, RefusesWhatHasTooManyPixels) {
  EXPECT_THROW(to_png(sample_drawing(), 9), UsageError);
  EXPECT_THROW(to_png(sample_drawing(), std::nan("")), UsageError);
  Drawing drawing = sample_drawing();
  drawing.width_mm = 1e12;
  EXPECT_THROW(to_png(drawing, 100), UsageError);
  drawing.width_mm = drawing.height_mm = 2000;
  EXPECT_THROW(to_png(drawing, 300), UsageError);
}

}  // namespace
}  // namespace spoctree::test
