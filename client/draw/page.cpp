#include "client/draw/page.hpp"

#include <algorithm>
#include <cmath>

#include "common/base/errors.hpp"
#include "common/base/parse_number.hpp"

namespace spoctree {

namespace {

// ISO 216; rounded to whole millimetres as the standard does.
constexpr PaperSize kPapers[] = {{841, 1189}, {594, 841}, {420, 594}, {297, 420},
                                 {210, 297},  {148, 210}, {105, 148}};

double parse_length(std::string_view word, std::string_view option, std::string_view whole) {
  const ParsedReal number = parse_real(word);
  if (number.fault != nullptr || !(number.value > 0))
    throw UsageError(std::string(option) + ": there is no number greater than 0 in '" +
                     std::string(whole) + "' where one should be");
  return number.value;
}

double largest_scale(Vec2 room, const PageContent& content) {
  const Vec2 left = room - content.rest_mm;
  return std::min(left.x / content.pictures.x, left.y / content.pictures.y);
}

}  // namespace

void parse_paper(std::string_view text, PageOptions& options) {
  if (text.size() == 2 && (text[0] == 'A' || text[0] == 'a') && text[1] >= '0' && text[1] <= '6') {
    options.paper = kPapers[text[1] - '0'];
    options.may_turn_paper = true;
    return;
  }
  const std::size_t times = text.find('x');
  if (times == std::string_view::npos)
    throw UsageError("--page: '" + std::string(text) +
                     "' should be A0 to A6, or WIDTHxHEIGHT in millimetres");
  options.paper = PaperSize{parse_length(text.substr(0, times), "--page", text),
                            parse_length(text.substr(times + 1), "--page", text)};
  options.may_turn_paper = false;
}

double parse_scale(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return parse_length(text, "--scale", text);
  const double scale = parse_length(text.substr(0, colon), "--scale", text) /
                       parse_length(text.substr(colon + 1), "--scale", text);
  if (!(scale > 0 && std::isfinite(scale)))
    throw UsageError("--scale: '" + std::string(text) + "' is out of range");
  return scale;
}

PageLayout lay_out(const PageContent& content, double model_scale, const PageOptions& options) {
  if (!(content.pictures.x > 0 && content.pictures.y > 0))
    throw UsageError("the frame of the drawing is empty");
  if (!(options.margin_mm >= 0)) throw UsageError("a page's margin cannot be negative");
  const Vec2 margins{2 * options.margin_mm};
  PageLayout page;
  Vec2 room{options.longest_mm - margins.x};
  if (options.paper) {
    const Vec2 upright = Vec2{options.paper->width_mm, options.paper->height_mm} - margins;
    const Vec2 turned = Vec2{options.paper->height_mm, options.paper->width_mm} - margins;
    room =
        options.may_turn_paper && largest_scale(turned, content) > largest_scale(upright, content)
            ? turned
            : upright;
  }
  const double largest = largest_scale(room, content);
  page.mm_per_unit = options.scale ? *options.scale * model_scale : largest;
  if (!(page.mm_per_unit > 0) || !std::isfinite(page.mm_per_unit))
    throw UsageError("the page has no room for a drawing");
  const Vec2 pictures = content.pictures * page.mm_per_unit;
  if (std::max(pictures.x, pictures.y) < options.least_mm)
    throw UsageError("the drawing would be smaller than 0.1 mm: choose a larger --scale or --page");
  const Vec2 size = pictures + content.rest_mm;
  if (options.paper) {
    constexpr double kRounding = 1 + 1e-9;
    if (page.mm_per_unit > largest * kRounding)
      throw UsageError("the page has no room for a drawing at this scale");
  } else {
    room = size;
  }
  page.width_mm = room.x + margins.x;
  page.height_mm = room.y + margins.y;
  if (!(std::max(page.width_mm, page.height_mm) <= kLargestPageMm))
    throw UsageError("the page would be more than 1e12 mm wide");
  page.origin_mm = 0.5 * (Vec2{page.width_mm, page.height_mm} - size);
  return page;
}

}  // namespace spoctree
