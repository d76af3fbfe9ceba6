// Names of views -> their places on a sheet, as projection methods have them (ISO 128-30,
// ISO 5456-2).
#pragma once

#include <string>
#include <vector>

#include "client/lines/camera.hpp"

namespace spoctree {

/// Where the views from the sides go around the one from the front.
enum class Projection {
  FirstAngle,  ///< ISO E: that from the left on the right, that from above below
  ThirdAngle   ///< ISO A: each on the side that it is seen from
};

/// Columns from left to right, rows from top to bottom, from 0 on.
struct SheetCell {
  int column = 0;
  int row = 0;
  bool operator==(const SheetCell&) const = default;
};

/// A cell for each name; columns and rows without a view are left out. `back` is on the far right.
/// `iso` is in a corner that the others leave free, below on the right in first-angle projection
/// and above there in third-angle projection if it can be; else in a column of its own on the
/// right, in no row of side views if there is another one.
/// REQUIRES: names of view_names(), none of them twice.
std::vector<SheetCell> arrange_views(const std::vector<std::string>& names, Projection projection);

/// Whether it matters to who reads the sheet by which method they are arranged: there are at least
/// two, `iso` not counted.
bool is_arranged_by_projection(const std::vector<std::string>& names);

/// The strokes of the standard's symbol, a truncated cone in two views: `height` high, with its
/// upper left corner at `at`, y downwards.
std::vector<std::vector<Vec2>> projection_symbol(Projection projection, Vec2 at, double height);
/// How wide that is.
double projection_symbol_width(double height);

}  // namespace spoctree
