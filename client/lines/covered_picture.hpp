// The part of the picture covered so far: a grid of tiles, and in each tile the convex polygons
// that cover some of it.
//
// The covered region grows only. A tile that is covered all over is marked full, and its polygons
// are forgotten: what lies behind full tiles need not be looked at (Veenstra and Ahuja 1988, with
// an index in place of the comparison of every edge with every earlier outline).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/lines/camera.hpp"
#include "client/lines/crease_parts.hpp"
#include "client/lines/half_plane.hpp"
#include "client/lines/square_remainder.hpp"
#include "common/base/plain_vector.hpp"
#include "common/base/small_count.hpp"

namespace spoctree {

class CoveredPicture {
 public:
  static constexpr std::size_t kMostEntries = (std::size_t{1} << 31) - 1;

  /// Nothing is covered yet; there will be about so many tiles, and at most so many entries: an
  /// outline in a tile is one.
  CoveredPicture(const Rectangle& bounds, std::size_t tiles,
                 std::size_t most_entries = kMostEntries);

  /// Adds a strictly convex polygon, counter-clockwise; what is out of bounds does not count. It
  /// covers what is nearer to it than `tolerance`, too: polygons that share an edge up to rounding
  /// leave no gap between them. Throws BadInput if there are too many entries, or sides of
  /// polygons.
  void cover(std::span<const Vec2> polygon, double tolerance);

  /// True if what lies in the rectangle is certainly covered, or out of bounds.
  bool is_full(const Rectangle& rectangle) const;

  /// Appends the parts of the line a + s (b - a), s in `part`, that are within bounds and not
  /// covered; its borders count as covered. The parts may touch and overlap.
  void find_uncovered(Vec2 a, Vec2 b, Interval part, std::vector<Interval>& uncovered);

 private:
  /// A polygon in a tile. Its half-planes stand one after the other in `half_planes_`.
  struct Entry {
    std::uint32_t first;
    std::uint32_t count;
    std::int32_t next;
  };
  struct Tile {
    std::int32_t first_entry = -1;
    std::uint32_t entry_count = 0;
    Rectangle open;  ///< nothing of the tile is uncovered outside
  };

  std::int64_t column_of(double coordinate, int axis) const;
  Vec2 lower_corner(std::int64_t column, std::int64_t row) const;
  bool is_full(std::int64_t column, std::int64_t row) const {
    return (full_[static_cast<std::size_t>(row) * words_per_row_ +
                  static_cast<std::size_t>(column / 64)] >>
                (column % 64) &
            1) != 0;
  }
  void mark_full(std::int64_t column, std::int64_t row);
  std::span<const HalfPlane> half_planes(const Entry& entry) const {
    return {half_planes_.data() + entry.first, entry.count};
  }

  void cover_tile(std::int64_t column, std::int64_t row, const Rectangle& extent,
                  std::uint32_t first, std::uint32_t count);
  bool shrink_open_box(Rectangle& open, std::uint32_t first, std::uint32_t count) const;
  /// The polygons of the tile leave nothing of it.
  bool is_covered_all_over(const Tile& tile, Vec2 lower);
  void look_at_tile(std::int64_t column, std::int64_t row, Vec2 a, Vec2 step, Interval part,
                    std::vector<Interval>& uncovered);

  Vec2 lower_;
  double tile_size_;
  std::int64_t tiles_along_[2];
  std::vector<Tile> tiles_;          // row by row
  std::vector<std::uint64_t> full_;  // one bit per tile, rows padded to whole words
  std::size_t words_per_row_;
  std::size_t most_entries_;
  PlainVector<HalfPlane> half_planes_;
  PlainVector<Entry> entries_;
  // Working memory.
  SquareRemainder rest_;
  std::vector<Interval> open_;
  std::vector<Interval> next_open_;
};

}  // namespace spoctree
