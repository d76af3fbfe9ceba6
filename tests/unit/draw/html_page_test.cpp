#include "client/draw/html_page.hpp"

#include <gtest/gtest.h>

#include "tests/unit/draw/read_back.hpp"
#include "tests/unit/draw/sample_drawing.hpp"

namespace spoctree::test {
namespace {

LevelRow row(std::uint32_t level, std::uint64_t bytes, std::uint64_t total) {
  LevelRow result;
  result.level = level;
  result.cost = {bytes, total};
  result.inner_volume = 12.5;
  result.outer_volume = 1234.5;
  result.error_percent = 0.25;
  return result;
}

HtmlPage page_of(int levels) {
  HtmlPage page;
  Drawing drawing = sample_drawing();
  for (StrokeGroup& group : drawing.groups) group.source.reset();
  for (int k = 0; k < levels; ++k) {
    drawing.title = "level " + std::to_string(k);
    page.add_level(drawing, row(static_cast<std::uint32_t>(k), 1000, 1000U * (1U + k)));
  }
  return page;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

/// The page without what is no markup.
std::string markup_of(std::string html) {
  html.erase(0, html.find("<html"));
  const std::size_t script = html.find("<script>\n");
  if (script != std::string::npos) html.erase(script, html.find("</script>") + 9 - script);
  return html;
}

TEST(HtmlPage, HasADrawingABarAndTheFactsOfEveryLevel) {
  const std::string html = page_of(3).finish({"piece", "mm", 3});
  EXPECT_EQ(count(html, "<section>"), 3U);
  EXPECT_EQ(count(html, "class=\"bar\""), 3U);
  EXPECT_EQ(count(html, "<dd>1,000</dd>"), 4U);  // each level, and level 0 in all
  EXPECT_EQ(count(html, "<dd>3,000</dd>"), 1U);
  EXPECT_EQ(count(html, "<dd>1234.5 mm\xC2\xB3</dd>"), 3U);
  EXPECT_EQ(count(html, "<dd>0.25 % of the diagonal</dd>"), 3U);
  EXPECT_EQ(html.find("class=\"note\""), std::string::npos);
  EXPECT_TRUE(is_well_formed_xml(markup_of(html)));
  EXPECT_EQ(read_svg(html).size(), 3U * 5U);
}

TEST(HtmlPage, NeedsNothingElse) {
  const std::string html = page_of(2).finish({"piece", "", 2});
  for (const char* reference : {"src=", "href=", "url(", "@import", "fetch("})
    EXPECT_EQ(html.find(reference), std::string::npos) << reference;
}

TEST(HtmlPage, SaysWhatIsMissing) {
  const std::string html = page_of(1).finish({"piece", "", 6});
  EXPECT_NE(html.find("level 0 of levels 0 to 5"), std::string::npos);
  EXPECT_NE(HtmlPage{}.finish({"piece", "", 6}).find("No level has arrived"), std::string::npos);
}

TEST(HtmlPage, EscapesWhatComesFromOutside) {
  const std::string evil = "</title><script>alert(1)</script>\"'&";
  const std::string html = page_of(1).finish({evil, evil, 1});
  EXPECT_EQ(count(html, "<script>"), 1U);
  EXPECT_EQ(count(html, "</script>"), 1U);
  EXPECT_TRUE(is_well_formed_xml(markup_of(html)));
}

}  // namespace
}  // namespace spoctree::test
