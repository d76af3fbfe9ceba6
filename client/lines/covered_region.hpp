// The part of the picture covered so far, exactly: a grid of tiles, and in each tile a binary space
// partition whose splitting lines are edges of the outlines that were put in.
//
// The covered region grows only. A tile that is covered all over is marked full, so that what lies
// behind full tiles need not be looked at (Veenstra and Ahuja 1988, with an index in place of the
// comparison of every edge with every earlier outline).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/lines/crease.hpp"

namespace spoctree {

/// A part of a line from `begin` to `end`, as parameters.
struct Interval {
  double begin = 0;
  double end = 0;
};

class CoveredRegion {
 public:
  /// Nothing is covered yet. Points nearer to a line than `tolerance` count as on it, so that
  /// outlines that share an edge up to rounding leave no gap between them.
  CoveredRegion(const Rectangle& bounds, std::uint32_t tiles_per_side, double tolerance);

  /// Adds a convex polygon, counter-clockwise. REQUIRES: it lies within the bounds.
  void cover(std::span<const Vec2> polygon);

  /// True if all tiles that the rectangle touches are full.
  bool is_full(const Rectangle& rectangle) const;

  /// Appends the parts of the line `origin` + t `step`, t in `part`, that are not covered. A part
  /// along the border of the covered region is judged from beside it: it is not covered if the
  /// picture is uncovered on one of the sides of the line named by `sides`. The parts may touch and
  /// overlap.
  void uncovered_parts(Vec2 origin, Vec2 step, Interval part, LineSides sides,
                       std::vector<Interval>& parts);

 private:
  /// A line of the picture, { p : normal . p = offset }; positive on the side of `normal`.
  struct Line {
    Vec2 normal{0.0};
    double offset = 0;
    double operator()(Vec2 p) const { return glm::dot(normal, p) - offset; }
  };
  struct HalfPlane {
    Line line;
    double sign = 1;  ///< the half-plane in which sign * line >= 0
  };
  /// Nodes name their children; leaves are kUncovered or kCovered.
  using Child = std::int32_t;
  static constexpr Child kUncovered = -1;
  static constexpr Child kCovered = -2;
  struct Node {
    Line line;
    Child negative = kUncovered;
    Child positive = kUncovered;
  };
  /// A corner of a polygon; `edge` is the outline's edge that leaves it, or kNoEdge where the
  /// polygon was cut or where the edge lies along a line that was split by before.
  struct Corner {
    Vec2 at{0.0};
    std::int32_t edge = 0;
  };
  static constexpr std::int32_t kNoEdge = -1;
  /// Polygons in work stand on the stack `corners_`.
  struct Polygon {
    std::size_t first = 0;
    std::size_t count = 0;
  };
  struct Tiles {
    std::uint32_t lower[2];
    std::uint32_t upper[2];  ///< exclusive
  };
  struct Sight {
    Vec2 origin, step;
    std::vector<Interval>* parts;
  };

  std::uint32_t column_of(double coordinate, int axis) const;
  Line boundary(int axis, std::uint32_t column) const;
  Tiles tiles_touched(const Rectangle& rectangle) const;

  void split(Polygon polygon, const Line& line, Polygon& negative, Polygon& positive);
  void cover_tiles(const Tiles& tiles, Polygon polygon);
  void cover_tile(std::uint32_t column, std::uint32_t row, Polygon polygon);
  void mark_full(const Tiles& tiles);
  void free_partition(Child child);
  Child cover_node(Child child, Polygon polygon);
  Child cover_leaf(Polygon polygon);
  Rectangle extent_of_leaf();
  Child new_node(const Line& line);

  void look_at_tiles(const Sight& sight, const Tiles& tiles, Interval part, LineSides sides);
  void look_at_node(const Sight& sight, Child child, Interval part, LineSides sides);
  /// Splits a part of a line; calls visit(is_positive, part, sides) for what lies on either side.
  template <class Visit>
  void split_sight(const Sight& sight, const Line& line, Interval part, LineSides sides,
                   Visit&& visit) const;

  Vec2 lower_;
  double tile_size_;
  std::uint32_t tiles_per_side_;
  double tolerance_;
  std::vector<Child> roots_;         // row by row
  std::vector<std::uint64_t> full_;  // one bit per tile, rows padded to whole words
  std::uint32_t words_per_row_;
  std::vector<Node> nodes_;
  std::vector<Child> free_nodes_;
  std::vector<Corner> corners_;
  std::vector<double> distances_;
  std::vector<Line> edges_;  // of the outline being added, positive inside
  std::vector<Vec2> region_;
  std::vector<Vec2> cut_region_;
  std::vector<HalfPlane> path_;  // from the tile to the node being worked on
};

}  // namespace spoctree
