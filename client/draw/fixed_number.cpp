#include "client/draw/fixed_number.hpp"

#include <cmath>

namespace spoctree {

GridPoint to_grid_point(Vec2 point_mm, double steps_per_mm) {
  return {std::llround(point_mm.x * steps_per_mm), std::llround(point_mm.y * steps_per_mm)};
}

void append_decimal(std::string& text, std::int64_t value, int decimals) {
  if (value < 0) text += '-';
  const std::string digits = std::to_string(value < 0 ? -value : value);
  const auto places = static_cast<std::size_t>(decimals);
  std::string padded = digits;
  if (padded.size() < places) padded.insert(0, places - padded.size(), '0');
  const std::size_t point = padded.size() - places;
  std::size_t end = padded.size();
  while (end > point && padded[end - 1] == '0') --end;
  if (point == 0 && end == 0) {
    text += '0';
    return;
  }
  text.append(padded, 0, point);
  if (end == point) return;
  text += '.';
  text.append(padded, point, end - point);
}

std::string to_decimal(double value, int decimals) {
  std::string text;
  append_decimal(text, std::llround(value * std::pow(10, decimals)), decimals);
  return text;
}

}  // namespace spoctree
