#include "client/draw/write_svg.hpp"

#include <gtest/gtest.h>

namespace spoctree {
namespace {

Drawing drawing_of(std::vector<Stroke> creases, std::vector<Stroke> silhouettes = {}) {
  Drawing drawing;
  drawing.width = 100;
  drawing.height = 62.5;
  drawing.layers[static_cast<std::size_t>(Layer::Crease)] = std::move(creases);
  drawing.layers[static_cast<std::size_t>(Layer::Silhouette)] = std::move(silhouettes);
  return drawing;
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(Svg, HasAPageAndAPathPerLayer) {
  const std::string svg = to_svg(drawing_of({{{1, 2}, {3.5, 4.25}}}, {{{0, 0}, {10, 0}, {10, 5}}}));
  EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_TRUE(contains(svg, "viewBox=\"0 0 100 62.5\""));
  EXPECT_TRUE(contains(svg, "<path class=\"crease\" d=\"M1 2L3.5 4.25\n\"/>"));
  EXPECT_TRUE(contains(svg, "<path class=\"silhouette\" d=\"M0 0L10 0L10 5\n\"/>"));
  EXPECT_FALSE(contains(svg, "class=\"hidden\""));
}

TEST(Svg, RoundsToHundredths) {
  const std::string svg = to_svg(drawing_of({{{0.004, 99.996}, {-0.055001, 12.3456}}}));
  EXPECT_TRUE(contains(svg, "M0 100L-0.06 12.35\n"));
}

TEST(Svg, LeavesOutWhatIsSmallerThanADot) {
  const std::string svg =
      to_svg(drawing_of({{{1, 1}, {1.001, 1.001}}, {{2, 2}, {2.001, 2}, {3, 2}}}));
  EXPECT_TRUE(contains(svg, "d=\"M2 2L3 2\n\""));
  EXPECT_FALSE(contains(svg, "M1 1"));
}

TEST(Svg, EscapesTheTitle) {
  SvgStyle style;
  style.title = "<a> & b\n";
  EXPECT_TRUE(contains(to_svg(drawing_of({}), style), "<title>&lt;a&gt; &amp; b </title>"));
}

}  // namespace
}  // namespace spoctree
