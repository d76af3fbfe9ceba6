// Numbers on a grid of decimals -> short text.
#pragma once

#include <cstdint>
#include <string>

#include "client/lines/camera.hpp"

namespace spoctree {

/// A point in multiples of a power of ten of a millimetre.
struct GridPoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const GridPoint&) const = default;
};

/// Millimetres to the nearest point of a grid of `steps_per_mm`. REQUIRES: |point| <=
/// kLargestPageMm, steps_per_mm <= 1000.
GridPoint to_grid_point(Vec2 point_mm, double steps_per_mm);

/// `value` / 10^decimals, without trailing zeros and without a zero before the point ("-.5").
void append_decimal(std::string& text, std::int64_t value, int decimals);

/// The same of a number that is rounded first.
std::string to_decimal(double value, int decimals);

}  // namespace spoctree
