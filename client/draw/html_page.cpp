#include "client/draw/html_page.hpp"

#include <algorithm>

#include "client/draw/fixed_number.hpp"
#include "client/draw/html_text.hpp"
#include "client/draw/write_svg.hpp"
#include "common/report/json_text.hpp"

namespace spoctree {

namespace {

/// "1,234,567".
std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ',');
  return text;
}

std::string fact(const std::string& name, const std::string& value) {
  return "<dt>" + name + "</dt><dd>" + escape_xml(value) + "</dd>\n";
}

std::string nodes_of(const LevelRow& row) {
  std::string text;
  for (int kind = 0; kind < kNodeKindCount; ++kind) {
    const std::uint32_t count = row.nodes[static_cast<std::size_t>(kind)];
    if (count == 0) continue;
    if (!text.empty()) text += ", ";
    text += grouped(count) + ' ' + kNodeKindNames[kind];
  }
  return text;
}

std::string facts_of(const LevelRow& row, const std::string& units) {
  const std::string cubic = units.empty() ? "" : ' ' + units + "\u00B3";
  return "<dl>\n" + fact("bytes of this level", grouped(row.cost.bytes)) +
         fact("bytes so far", grouped(row.cost.total_bytes)) +
         fact("error at most", row.error_percent == 0
                                   ? "0: exact"
                                   : to_short_text(row.error_percent) + " % of the diagonal") +
         fact("volume at least", to_short_text(row.inner_volume) + cubic) +
         fact("volume at most", to_short_text(row.outer_volume) + cubic) +
         fact("nodes", nodes_of(row)) + fact("new planes", grouped(row.new_planes)) + "</dl>\n";
}

/// A bar per level, as high as its bytes; the tallest has the whole height.
std::string chart_of(const std::vector<LevelRow>& rows) {
  constexpr double kBar = 22;
  constexpr double kStep = 26;
  constexpr double kHeight = 80;
  constexpr double kText = 14;
  std::uint64_t most = 1;
  for (const LevelRow& row : rows) most = std::max(most, row.cost.bytes);
  const double width = kStep * static_cast<double>(rows.size());
  std::string svg = "<svg class=\"chart\" viewBox=\"0 0 " + to_decimal(width, 1) + ' ' +
                    to_decimal(kHeight + kText, 1) +
                    "\" style=\"max-width:" + to_decimal(width * 1.6, 0) +
                    "px\" role=\"img\" aria-label=\"bytes of each level\">\n";
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double share = static_cast<double>(rows[k].cost.bytes) / static_cast<double>(most);
    const double height = std::max(1.0, share * kHeight);
    const double x = kStep * static_cast<double>(k) + 0.5 * (kStep - kBar);
    const std::string level = std::to_string(rows[k].level);
    svg += "<g class=\"bar\" data-index=\"" + std::to_string(k) + "\"><title>level " + level +
           ": " + grouped(rows[k].cost.bytes) + " bytes</title><rect x=\"" + to_decimal(x, 1) +
           "\" y=\"" + to_decimal(kHeight - height, 1) + "\" width=\"" + to_decimal(kBar, 1) +
           "\" height=\"" + to_decimal(height, 1) + "\"/><text x=\"" +
           to_decimal(x + 0.5 * kBar, 1) + "\" y=\"" + to_decimal(kHeight + kText - 3, 1) + "\">" +
           level + "</text></g>\n";
  }
  return svg + "</svg>\n";
}

std::string levels_text(std::size_t count) {
  return count == 1 ? "level 0" : "levels 0 to " + std::to_string(count - 1);
}

}  // namespace

void HtmlPage::add_level(const Drawing& drawing, const LevelRow& row) {
  SvgOptions options;
  options.is_document = false;
  levels_.push_back({to_svg(drawing, options), row});
}

std::string HtmlPage::finish(const Facts& facts) const {
  const std::string model = escape_xml(facts.model);
  std::vector<LevelRow> rows;
  for (const Shown& level : levels_) rows.push_back(level.row);
  std::string html = std::string("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n") + kHtmlHead +
                     "<title>" + model + "</title>\n<style>\n" + kHtmlStyle + svg_style() +
                     "</style>\n</head>\n<body>\n<h1>" + model + "</h1>\n";
  if (levels_.empty()) return html + "<p>No level has arrived.</p>\n</body>\n</html>\n";
  if (levels_.size() < facts.level_count) {
    html +=
        "<p class=\"note\">The transmission ended before its end: " + levels_text(levels_.size()) +
        " of " + levels_text(facts.level_count) + ".</p>\n";
  }
  html += kHtmlControls;
  html += "<main>\n";
  for (const Shown& level : levels_) {
    html += "<section><h2>Level " + std::to_string(level.row.level) +
            "</h2>\n<div class=\"paper\">" + level.svg + "</div>\n" +
            facts_of(level.row, facts.units) + "</section>\n";
  }
  html += "</main>\n<h2 class=\"chart-title\">Bytes of each level</h2>\n" + chart_of(rows);
  return html + "<script>\n" + kHtmlScript + "</script>\n</body>\n</html>\n";
}

}  // namespace spoctree
