// How uneven a face may be: a tolerance, and how far its corners were rounded before.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "common/geometry/tolerances.hpp"
#include "server/solid/planar_patch.hpp"

namespace spoctree {

/// What counts as flat. Lengths in universe units.
struct FlatTolerance {
  double spread = 0;  ///< corners of one face lie between two parallel planes this far apart
  /// Coordinates along each axis were rounded to multiples of this, or may have been; 0: they say
  /// what they mean.
  std::array<double, 3> rounding{};

  bool has_rounding() const { return std::max({rounding[0], rounding[1], rounding[2]}) > 0; }

  /// Between which two parallel planes corners may lie that were rounded, if they were on one plane
  /// with this direction before: rounding moves none of them by more than half a unit along any
  /// axis.
  double rounded_spread(const GridPoint& normal) const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += std::abs(static_cast<double>(normal[i])) * 0x1p-52 * rounding[i];
    }
    return std::max(spread, kRoundingSlack * sum);
  }

  /// Corners move onto their planes by less than this.
  double most_move() const {
    double squared = 0;
    for (const double unit : rounding) squared += unit * unit;
    return std::max(kMostMoves * spread, kRoundingSlack * 0.5 * std::sqrt(squared));
  }

 private:
  // A little less than twice.
  static constexpr double kMostMoves = 2 - 0x1p-20;
};

}  // namespace spoctree
