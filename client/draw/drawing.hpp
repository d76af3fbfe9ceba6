// Strokes on a page: what every writer of a format gets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/draw/pen.hpp"
#include "client/lines/camera.hpp"
#include "client/lines/visible_line.hpp"
#include "common/geometry/universe.hpp"

namespace spoctree {

/// Two planes that meet in a line.
using PlanePair = std::array<PlaneRef, 2>;

/// The pen goes down at the first of the points and up at the last.
struct Stroke {
  std::uint32_t begin = 0;  ///< offsets into the group's points
  std::uint32_t end = 0;
  std::uint32_t planes_begin = 0;  ///< offsets into the group's planes
  std::uint32_t planes_end = 0;
  /// Dashed pens: how far its beginning is into the dashes, which began with the first stroke of a
  /// chain.
  double dashes_before_mm = 0;
};

/// Strokes that have everything in common but their planes. Where there are planes, each stroke is
/// straight, and has a pair for each of its stretches, in order.
struct StrokeGroup {
  Pen pen;
  /// Where the tree has the lines from; nothing if nobody asked, and for letters.
  std::optional<LineSource> source;
  std::vector<Vec2> points;
  std::vector<PlanePair> planes;
  std::vector<Stroke> strokes;

  std::span<const Vec2> points_of(const Stroke& stroke) const {
    return {points.data() + stroke.begin, stroke.end - stroke.begin};
  }
  std::span<const PlanePair> planes_of(const Stroke& stroke) const {
    return {planes.data() + stroke.planes_begin, stroke.planes_end - stroke.planes_begin};
  }
};

/// A page. Millimetres; the origin is the upper left corner, y goes downwards.
struct Drawing {
  std::string title;  ///< UTF-8 without control characters
  double width_mm = 0;
  double height_mm = 0;
  double scale = 1;                 ///< millimetres per model unit
  std::vector<StrokeGroup> groups;  ///< in drawing order; those of one pen are neighbours
  Universe universe;                ///< for the names of cell walls
};

/// What a plane is called in a drawing's data: its number in the plane table, or a cell wall as
/// "x=12.5", in model coordinates. The same for both sides of a plane.
std::string name_of(PlaneRef plane, const Universe& universe);

/// "convex", ...; "/inherited" follows if neither plane stands in that node itself.
std::string name_of(const LineSource& source);

}  // namespace spoctree
