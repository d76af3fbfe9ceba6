#include "client/draw/write_svg.hpp"

#include "client/draw/fixed_number.hpp"

namespace spoctree {

namespace {

constexpr int kDecimals = 2;
constexpr double kStepsPerMm = 100;

std::string length(double mm) { return to_decimal(mm, kDecimals); }

/// "12-3.5": a minus separates as well as a blank does.
void append_pair(std::string& svg, std::int64_t x, std::int64_t y) {
  append_decimal(svg, x, kDecimals);
  if (y >= 0) svg += ' ';
  append_decimal(svg, y, kDecimals);
}

void append_step(std::string& svg, GridPoint from, GridPoint to) {
  const std::int64_t dx = to.x - from.x;
  const std::int64_t dy = to.y - from.y;
  if (dy == 0) {
    svg += 'h';
    append_decimal(svg, dx, kDecimals);
  } else if (dx == 0) {
    svg += 'v';
    append_decimal(svg, dy, kDecimals);
  } else {
    svg += 'l';
    append_pair(svg, dx, dy);
  }
}

/// Adds the stroke to path data; false if nothing is left of it.
bool append_stroke(std::string& svg, std::span<const Vec2> points) {
  GridPoint last = to_grid_point(points.front(), kStepsPerMm);
  bool is_started = false;
  for (const Vec2 point : points.subspan(1)) {
    const GridPoint next = to_grid_point(point, kStepsPerMm);
    if (next == last) continue;
    if (!is_started) {
      svg += 'M';
      append_pair(svg, last.x, last.y);
      is_started = true;
    }
    append_step(svg, last, next);
    last = next;
  }
  return is_started;
}

/// Not less than it is by whole dashes, so that a style sheet may change these.
std::string dash_offset(const Stroke& stroke) {
  const std::string offset = length(stroke.dashes_before_mm);
  return offset == "0" ? "" : " stroke-dashoffset=\"" + offset + '"';
}

void append_plain_group(std::string& svg, const StrokeGroup& group) {
  std::string data;
  std::string offset;
  const auto finish = [&] {
    if (data.empty()) return;
    data.pop_back();
    svg += "<path class=\"" + name_of(group.pen, ' ') + '"' + offset + " d=\"" + data + "\"/>\n";
    data.clear();
  };
  for (const Stroke& stroke : group.strokes) {
    if (dash_offset(stroke) != offset) {
      finish();
      offset = dash_offset(stroke);
    }
    if (append_stroke(data, group.points_of(stroke))) data += '\n';
  }
  finish();
}

void append_group_with_data(std::string& svg, const StrokeGroup& group, const Universe& universe) {
  std::string paths;
  for (const Stroke& stroke : group.strokes) {
    std::string data;
    if (!append_stroke(data, group.points_of(stroke))) continue;
    paths += "<path";
    std::string planes;
    for (const PlanePair& pair : group.planes_of(stroke))
      planes += (planes.empty() ? "" : ", ") + name_of(pair[0], universe) + ' ' +
                name_of(pair[1], universe);
    if (!planes.empty()) paths += " data-planes=\"" + planes + '"';
    paths += dash_offset(stroke) + " d=\"" + data + "\"/>\n";
  }
  if (paths.empty()) return;
  svg += "<g class=\"" + name_of(group.pen, ' ') + "\" data-node=\"" + name_of(*group.source) +
         "\" data-level=\"" + std::to_string(group.source->level) + "\">\n" + paths + "</g>\n";
}

std::string rule(const std::string& selector, const Pen& pen) {
  return selector + "{stroke:" + to_hex(colour_of(pen)) +
         ";stroke-width:" + to_decimal(width_mm(pen), 2) + "}\n";
}

std::string stroke_colour(const Pen& pen) { return "{stroke:" + to_hex(colour_of(pen)); }

}  // namespace

std::string svg_style() {
  std::string style = "path{fill:none;stroke-linecap:round;stroke-linejoin:round}\n";
  Pen pen;
  style += rule(".crease,.caption", pen);
  pen.use = PenUse::Silhouette;
  style += rule(".silhouette", pen);
  pen.is_step = true;
  style += ".step" + stroke_colour(pen) + "}\n";
  pen = {};
  pen.hidden = true;
  style += ".hidden" + stroke_colour(pen) + ";stroke-width:" + to_decimal(width_mm(pen), 2) +
           ";stroke-dasharray:" + to_decimal(kDashMm, 2) + ' ' + to_decimal(kDashGapMm, 2) + "}\n";
  pen = {};
  for (int ink = 1; ink < kInkCount; ++ink) {
    pen.ink = static_cast<Ink>(ink);
    const std::string name = name_of(pen, '.');
    style += name.substr(name.find('.')) + stroke_colour(pen);
    const bool is_glass = pen.ink == Ink::LeftEye || pen.ink == Ink::RightEye;
    style += is_glass ? ";mix-blend-mode:multiply}\n" : "}\n";
  }
  return style;
}

std::string escape_xml(std::string_view text) {
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
      case '"':
        result += "&quot;";
        break;
      default:
        // Control characters are not allowed in XML, not even escaped.
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

std::string to_svg(const Drawing& drawing, const SvgOptions& options) {
  const std::string width = length(drawing.width_mm);
  const std::string height = length(drawing.height_mm);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
  if (options.is_document) svg += " width=\"" + width + "mm\" height=\"" + height + "mm\"";
  svg += " viewBox=\"0 0 " + width + ' ' + height + "\">\n";
  if (!drawing.title.empty()) svg += "<title>" + escape_xml(drawing.title) + "</title>\n";
  if (options.is_document) {
    svg += "<style>\n.paper{fill:#fff}\n" + svg_style() + "</style>\n";
    svg += "<rect class=\"paper\" width=\"" + width + "\" height=\"" + height + "\"/>\n";
  }
  for (const StrokeGroup& group : drawing.groups) {
    if (group.source) {
      append_group_with_data(svg, group, drawing.universe);
    } else {
      append_plain_group(svg, group);
    }
  }
  svg += "</svg>\n";
  return svg;
}

}  // namespace spoctree
