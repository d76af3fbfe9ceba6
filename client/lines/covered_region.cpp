#include "client/lines/covered_region.hpp"

#include <algorithm>
#include <cmath>

namespace spoctree {

CoveredRegion::CoveredRegion(const Rectangle& bounds, std::uint32_t tiles_per_side,
                             double tolerance)
    : tiles_per_side_(tiles_per_side), tolerance_(tolerance) {
  // A little larger and off the bounds, by fractions that keep the borders of tiles away from the
  // walls of cells in views along the axes.
  const Vec2 size = bounds.upper - bounds.lower;
  const double side = std::max(size.x, size.y);
  lower_ = bounds.lower - Vec2{0.01237, 0.01193} * side;
  tile_size_ = side * 1.03141 / tiles_per_side_;
  words_per_row_ = (tiles_per_side_ + 63) / 64;
  roots_.assign(std::size_t{tiles_per_side_} * tiles_per_side_, kUncovered);
  full_.assign(std::size_t{words_per_row_} * tiles_per_side_, 0);
}

std::uint32_t CoveredRegion::column_of(double coordinate, int axis) const {
  const double column = std::floor((coordinate - lower_[axis]) / tile_size_);
  return static_cast<std::uint32_t>(std::clamp(column, 0.0, tiles_per_side_ - 1.0));
}

CoveredRegion::Line CoveredRegion::boundary(int axis, std::uint32_t column) const {
  Line line;
  line.normal[axis] = 1;
  line.offset = lower_[axis] + column * tile_size_;
  return line;
}

CoveredRegion::Tiles CoveredRegion::tiles_touched(const Rectangle& rectangle) const {
  Tiles tiles;
  for (int axis = 0; axis < 2; ++axis) {
    tiles.lower[axis] = column_of(rectangle.lower[axis], axis);
    tiles.upper[axis] = column_of(rectangle.upper[axis], axis) + 1;
  }
  return tiles;
}

bool CoveredRegion::is_full(const Rectangle& rectangle) const {
  const Tiles tiles = tiles_touched(rectangle);
  const std::uint32_t first_word = tiles.lower[0] / 64;
  const std::uint32_t last_word = (tiles.upper[0] - 1) / 64;
  for (std::uint32_t row = tiles.lower[1]; row < tiles.upper[1]; ++row) {
    const std::uint64_t* words = full_.data() + std::size_t{row} * words_per_row_;
    for (std::uint32_t word = first_word; word <= last_word; ++word) {
      std::uint64_t wanted = ~std::uint64_t{0};
      if (word == first_word) wanted &= ~std::uint64_t{0} << (tiles.lower[0] % 64);
      if (word == last_word) wanted &= ~std::uint64_t{0} >> (63 - (tiles.upper[0] - 1) % 64);
      if ((words[word] & wanted) != wanted) return false;
    }
  }
  return true;
}

void CoveredRegion::mark_full(const Tiles& tiles) {
  for (std::uint32_t row = tiles.lower[1]; row < tiles.upper[1]; ++row) {
    for (std::uint32_t column = tiles.lower[0]; column < tiles.upper[0]; ++column) {
      Child& root = roots_[std::size_t{row} * tiles_per_side_ + column];
      free_partition(root);
      root = kCovered;
      full_[std::size_t{row} * words_per_row_ + column / 64] |= std::uint64_t{1} << (column % 64);
    }
  }
}

void CoveredRegion::free_partition(Child child) {
  if (child < 0) return;
  free_partition(nodes_[static_cast<std::size_t>(child)].negative);
  free_partition(nodes_[static_cast<std::size_t>(child)].positive);
  free_nodes_.push_back(child);
}

template <class Visit>
void CoveredRegion::split_sight(const Sight& sight, const Line& line, Interval part,
                                LineSides sides, Visit&& visit) const {
  const double from = line(sight.origin + sight.step * part.begin);
  const double to = line(sight.origin + sight.step * part.end);
  if (std::abs(from) <= tolerance_ && std::abs(to) <= tolerance_) {
    const Vec2 left{-sight.step.y, sight.step.x};
    const bool left_is_positive = glm::dot(line.normal, left) > 0;
    const LineSides positive = left_is_positive ? kLeftSide : kRightSide;
    if ((sides & positive) != 0) visit(true, part, static_cast<LineSides>(sides & positive));
    if ((sides & ~positive) != 0) visit(false, part, static_cast<LineSides>(sides & ~positive));
  } else if (from >= -tolerance_ && to >= -tolerance_) {
    visit(true, part, sides);
  } else if (from <= tolerance_ && to <= tolerance_) {
    visit(false, part, sides);
  } else {
    const double crossing = part.begin + (part.end - part.begin) * (from / (from - to));
    visit(from > 0, Interval{part.begin, crossing}, sides);
    visit(to > 0, Interval{crossing, part.end}, sides);
  }
}

void CoveredRegion::uncovered_parts(Vec2 origin, Vec2 step, Interval part, LineSides sides,
                                    std::vector<Interval>& parts) {
  const Vec2 a = origin + step * part.begin;
  const Vec2 b = origin + step * part.end;
  const Vec2 margin{tolerance_, tolerance_};
  const Tiles tiles = tiles_touched({glm::min(a, b) - margin, glm::max(a, b) + margin});
  look_at_tiles({origin, step, &parts}, tiles, part, sides);
}

void CoveredRegion::look_at_tiles(const Sight& sight, const Tiles& tiles, Interval part,
                                  LineSides sides) {
  const std::uint32_t width = tiles.upper[0] - tiles.lower[0];
  const std::uint32_t height = tiles.upper[1] - tiles.lower[1];
  if (width == 1 && height == 1) {
    look_at_node(sight, roots_[std::size_t{tiles.lower[1]} * tiles_per_side_ + tiles.lower[0]],
                 part, sides);
    return;
  }
  const int axis = width >= height ? 0 : 1;
  const std::uint32_t middle = (tiles.lower[axis] + tiles.upper[axis]) / 2;
  split_sight(sight, boundary(axis, middle), part, sides,
              [&](bool is_positive, Interval piece, LineSides piece_sides) {
                Tiles half = tiles;
                (is_positive ? half.lower : half.upper)[axis] = middle;
                look_at_tiles(sight, half, piece, piece_sides);
              });
}

void CoveredRegion::look_at_node(const Sight& sight, Child child, Interval part, LineSides sides) {
  if (child == kCovered) return;
  if (child == kUncovered) {
    sight.parts->push_back(part);
    return;
  }
  const Node node = nodes_[static_cast<std::size_t>(child)];
  split_sight(
      sight, node.line, part, sides, [&](bool is_positive, Interval piece, LineSides piece_sides) {
        look_at_node(sight, is_positive ? node.positive : node.negative, piece, piece_sides);
      });
}

}  // namespace spoctree
