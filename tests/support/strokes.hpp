// Segments in space and in the picture -> what lies near them, on them, or continues them.
#pragma once

#include <vector>

#include "tests/support/near_parts.hpp"
#include "tests/support/picture_grid.hpp"

namespace spoctree {

/// A segment in space and in the picture (z = 0).
struct Stroke {
  Segment space;
  Segment picture;

  double length() const;  ///< in the picture
};

/// Strokes, the longest first, and where they are. Not for several threads.
class Strokes {
 public:
  /// `pad` and `half_width` as for PictureGrid: distances asked for must be less than `pad`.
  Strokes(std::vector<Stroke> strokes, double pad, double half_width);

  const std::vector<Stroke>& all() const { return strokes_; }

  /// The parts of a stroke in the picture that are near one of these.
  Parts near(const Stroke& stroke, double distance);
  /// The same in space; parts of the segment in space.
  Parts near_in_space(const Stroke& stroke, double distance);

  /// The parts of a stroke in the picture along which one of these lies, or one of the first
  /// `count`.
  Parts along(const Stroke& stroke, double distance, std::size_t count);
  Parts along(const Stroke& stroke, double distance) {
    return along(stroke, distance, strokes_.size());
  }

  /// How many lines are left if all that continue each other, or overlap, become one.
  std::size_t count_runs(double distance);

 private:
  Parts near_as(Segment Stroke::*segment, const Stroke& stroke, double distance);

  std::vector<Stroke> strokes_;
  PictureGrid grid_;
};

}  // namespace spoctree
