#include "client/draw/write_svg.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace spoctree {

namespace {

constexpr const char* kLayerNames[kLayerCount] = {"hidden", "crease", "silhouette"};

/// Hundredths of the page's unit.
struct Dot {
  std::int64_t x = 0, y = 0;
  bool operator==(const Dot&) const = default;
};

Dot round_to_dot(Vec2 point) { return {std::llround(point.x * 100), std::llround(point.y * 100)}; }

/// Without trailing zeros.
void append_hundredths(std::string& text, std::int64_t value) {
  if (value < 0) text += '-';
  const std::int64_t magnitude = std::abs(value);
  text += std::to_string(magnitude / 100);
  const int rest = static_cast<int>(magnitude % 100);
  if (rest == 0) return;
  text += '.';
  text += static_cast<char>('0' + rest / 10);
  if (rest % 10 != 0) text += static_cast<char>('0' + rest % 10);
}

std::string hundredths(double value) {
  std::string text;
  append_hundredths(text, std::llround(value * 100));
  return text;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        // Control characters are not allowed in XML, not even escaped.
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

void append_path(std::string& svg, const std::vector<Stroke>& strokes) {
  for (const Stroke& stroke : strokes) {
    bool is_started = false;
    Dot last = round_to_dot(stroke.front());
    for (std::size_t k = 1; k < stroke.size(); ++k) {
      const Dot dot = round_to_dot(stroke[k]);
      if (dot == last) continue;
      if (!is_started) {
        svg += "M";
        append_hundredths(svg, last.x);
        svg += ' ';
        append_hundredths(svg, last.y);
        is_started = true;
      }
      svg += 'L';
      append_hundredths(svg, dot.x);
      svg += ' ';
      append_hundredths(svg, dot.y);
      last = dot;
    }
    if (is_started) svg += '\n';
  }
}

}  // namespace

std::string to_svg(const Drawing& drawing, const SvgStyle& style) {
  const std::string width = hundredths(drawing.width);
  const std::string height = hundredths(drawing.height);
  std::string svg;
  svg += R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" + width + R"(" height=")" + height +
         R"(" viewBox="0 0 )" + width + ' ' + height + "\">\n";
  if (!style.title.empty()) svg += "<title>" + escaped(style.title) + "</title>\n";
  svg +=
      "<style>\n"
      ".paper{fill:#fff}\n"
      "path{fill:none;stroke:#000;stroke-linecap:round;stroke-linejoin:round}\n";
  svg += "path.hidden{stroke:#888;stroke-dasharray:4 4;stroke-width:" +
         hundredths(style.hidden_width) + "}\n";
  svg += "path.crease{stroke-width:" + hundredths(style.crease_width) + "}\n";
  svg += "path.silhouette{stroke-width:" + hundredths(style.silhouette_width) + "}\n";
  svg += "</style>\n";
  svg += "<rect class=\"paper\" width=\"" + width + "\" height=\"" + height + "\"/>\n";
  for (int layer = 0; layer < kLayerCount; ++layer) {
    const auto& strokes = drawing.strokes(static_cast<Layer>(layer));
    if (strokes.empty()) continue;
    svg += "<path class=\"";
    svg += kLayerNames[layer];
    svg += "\" d=\"";
    append_path(svg, strokes);
    svg += "\"/>\n";
  }
  svg += "</svg>\n";
  return svg;
}

}  // namespace spoctree
