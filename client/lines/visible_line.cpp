#include "client/lines/visible_line.hpp"

#include <algorithm>
#include <utility>

namespace spoctree {

bool LineStretch::goes_on_in(const LineStretch& next) const {
  return source == next.source && ((planes[0] == next.planes[0] && planes[1] == next.planes[1]) ||
                                   (planes[0] == next.planes[1] && planes[1] == next.planes[0]));
}

std::vector<LineStretch> stretches_of(const VisibleLine& line) {
  if (!line.stretches.empty()) return line.stretches;
  return {{1, line.source, {line.planes[0], line.planes[1]}}};
}

void set_stretches(VisibleLine& line, std::span<const LineStretch> stretches) {
  line.stretches.clear();
  const auto differs = [&](const LineStretch& next) { return !stretches[0].goes_on_in(next); };
  if (std::any_of(stretches.begin(), stretches.end(), differs)) {
    for (const LineStretch& stretch : stretches) {
      if (!line.stretches.empty() && line.stretches.back().goes_on_in(stretch)) {
        line.stretches.back().end = stretch.end;
      } else {
        line.stretches.push_back(stretch);
      }
    }
    stretches = line.stretches;
  }
  double longest = -1;
  double begin = 0;
  for (const LineStretch& stretch : stretches) {
    if (stretch.end - begin > longest) {
      longest = stretch.end - begin;
      line.source = stretch.source;
      std::copy(stretch.planes, stretch.planes + 2, line.planes);
    }
    begin = stretch.end;
  }
}

VisibleLine cut(const VisibleLine& line, double begin, double end) {
  VisibleLine part = line;
  if (begin > 0) part.a = line.a + begin * (line.b - line.a);
  if (end < 1) part.b = line.a + end * (line.b - line.a);
  if (line.stretches.empty() || !(begin < end)) return part;
  std::vector<LineStretch> stretches;
  for (LineStretch stretch : line.stretches) {
    if (stretch.end <= begin) continue;
    const bool is_last = stretch.end >= end;
    stretch.end = is_last ? 1 : (stretch.end - begin) / (end - begin);
    stretches.push_back(stretch);
    if (is_last) break;
  }
  set_stretches(part, stretches);
  return part;
}

void reverse(VisibleLine& line) {
  std::swap(line.a, line.b);
  if (line.stretches.empty()) return;
  double begin = 0;
  for (LineStretch& stretch : line.stretches) begin = std::exchange(stretch.end, 1 - begin);
  std::reverse(line.stretches.begin(), line.stretches.end());
}

VisibleLine reversed(VisibleLine line) {
  reverse(line);
  return line;
}

}  // namespace spoctree
