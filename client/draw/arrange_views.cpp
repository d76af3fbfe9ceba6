#include "client/draw/arrange_views.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <set>
#include <utility>

namespace spoctree {

namespace {

/// Around the view from the front at (0, 0); `iso` is elsewhere.
SheetCell place_around_front(const std::string& name, Projection projection) {
  const int side = projection == Projection::FirstAngle ? 1 : -1;
  if (name == "left") return {side, 0};
  if (name == "right") return {-side, 0};
  if (name == "top") return {0, side};
  if (name == "bottom") return {0, -side};
  if (name == "back") return {2, 0};
  return {0, 0};
}

struct Used {
  std::set<int> columns;
  std::set<int> rows;
};

/// Where `iso` goes: columns to the right first, then rows where first or third angle has `top`.
SheetCell free_corner(const Used& used, Projection projection) {
  const int top = projection == Projection::FirstAngle ? 1 : -1;
  for (const int row : {top, -top}) {
    for (const int column : {1, -1, 2}) {
      if (used.columns.contains(column) && used.rows.contains(row)) return {column, row};
    }
  }
  constexpr int kOnTheRight = 3;
  for (const int row : {top, -top}) {
    if (used.rows.contains(row)) return {kOnTheRight, row};
  }
  return {kOnTheRight, 0};
}

int rank_in(const std::set<int>& used, int value) {
  return static_cast<int>(std::distance(used.begin(), used.find(value)));
}

// Fractions of the symbol's height.
constexpr double kSymbolGap = 0.5;       ///< between its two views
constexpr double kSymbolBeyond = 0.125;  ///< from a view to the end of its centre line

}  // namespace

std::vector<SheetCell> arrange_views(const std::vector<std::string>& names, Projection projection) {
  Used used;
  for (const std::string& name : names) {
    if (name == "iso") continue;
    const SheetCell cell = place_around_front(name, projection);
    used.columns.insert(cell.column);
    used.rows.insert(cell.row);
  }
  const SheetCell corner = free_corner(used, projection);
  if (std::find(names.begin(), names.end(), "iso") != names.end()) {
    used.columns.insert(corner.column);
    used.rows.insert(corner.row);
  }
  std::vector<SheetCell> cells;
  for (const std::string& name : names) {
    const SheetCell cell = name == "iso" ? corner : place_around_front(name, projection);
    cells.push_back({rank_in(used.columns, cell.column), rank_in(used.rows, cell.row)});
  }
  return cells;
}

bool is_arranged_by_projection(const std::vector<std::string>& names) {
  return std::count_if(names.begin(), names.end(),
                       [](const std::string& name) { return name != "iso"; }) >= 2;
}

std::vector<std::vector<Vec2>> projection_symbol(Projection projection, Vec2 at, double height) {
  constexpr int kCircleSides = 48;
  const double large = 0.5 * height;  // radius
  const double small = 0.5 * large;
  const double step = (1 + kSymbolGap) * height;
  // The cone's small end points to the left, and its other view shows that end.
  const bool is_first = projection == Projection::FirstAngle;
  const Vec2 left = at + Vec2{kSymbolBeyond * height, large};
  const Vec2 cone = left + Vec2{is_first ? 0 : step, 0};  // the middle of its left side
  const Vec2 middle = left + Vec2{large + (is_first ? step : 0), 0};
  std::vector<std::vector<Vec2>> strokes;
  strokes.push_back({cone + Vec2{0, -small}, cone + Vec2{height, -large},
                     cone + Vec2{height, large}, cone + Vec2{0, small}, cone + Vec2{0, -small}});
  for (const double radius : {large, small}) {
    strokes.emplace_back();
    for (int k = 0; k <= kCircleSides; ++k) {
      const double angle = 2 * std::numbers::pi * (k % kCircleSides) / kCircleSides;
      strokes.back().push_back(middle + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
  }
  const double beyond = kSymbolBeyond * height;
  const Vec2 across{large + beyond, 0};
  const Vec2 upright{0, large};
  const std::vector<std::vector<Vec2>> center_lines = {
      {cone - Vec2{beyond, 0}, cone + Vec2{height + beyond, 0}},
      {middle - across, middle + across},
      {middle - upright, middle + upright}};
  // A long dash, a dot, a long dash.
  for (const auto& line : center_lines) {
    for (const auto& [begin, end] : {std::pair(0.0, 0.4), {0.47, 0.53}, {0.6, 1.0}})
      strokes.push_back({glm::mix(line[0], line[1], begin), glm::mix(line[0], line[1], end)});
  }
  return strokes;
}

double projection_symbol_width(double height) {
  return (2 + kSymbolGap + 2 * kSymbolBeyond) * height;
}

}  // namespace spoctree
