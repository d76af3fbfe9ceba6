#include "client/lines/covered_picture.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace spoctree {

namespace {

/// Whether a rectangle reaches into what is open; its border alone does not.
bool do_overlap(const Rectangle& rectangle, const Rectangle& open) {
  constexpr double kRounding = 1e-15;
  return rectangle.upper.x > open.lower.x + kRounding &&
         rectangle.upper.y > open.lower.y + kRounding &&
         rectangle.lower.x < open.upper.x - kRounding &&
         rectangle.lower.y < open.upper.y - kRounding;
}

/// Pictures are not smaller than this.
constexpr double kLeastSize = 1e-9;

/// Where a line through a point so many units off runs is known up to this times as much.
constexpr double kRounding = 1e-15;

/// Most tiles are full when one polygon covers them, soon behind the surface. Where that does not
/// happen, as where seams lie one behind the other, what all polygons leave is found out when there
/// are so many of them, and again whenever there are twice as many.
constexpr std::uint32_t kManyEntries = 64;

}  // namespace

CoveredPicture::CoveredPicture(const Rectangle& bounds, std::size_t tiles, std::size_t most_entries)
    : most_entries_(most_entries) {
  // A little larger and off the bounds, by fractions that keep the borders of tiles away from the
  // walls of cells in views along the axes.
  const Vec2 size = 1.03141 * glm::max(bounds.upper - bounds.lower, Vec2{kLeastSize, kLeastSize});
  lower_ = bounds.lower - Vec2{0.01237, 0.01193} * size;
  const auto count = static_cast<double>(std::max<std::size_t>(tiles, 1));
  tile_size_ = std::max(std::sqrt(size.x * size.y / count), std::max(size.x, size.y) / count);
  for (int axis = 0; axis < 2; ++axis) {
    tiles_along_[axis] = static_cast<std::int64_t>(std::ceil(size[axis] / tile_size_));
  }
  words_per_row_ = static_cast<std::size_t>((tiles_along_[0] + 63) / 64);
  const auto rows = static_cast<std::size_t>(tiles_along_[1]);
  tiles_.resize(static_cast<std::size_t>(tiles_along_[0]) * rows);
  // A little larger than the tile, so that lines along its border are within.
  const Vec2 margin = 1e-9 * Vec2{tile_size_, tile_size_};
  std::size_t number = 0;
  for (std::int64_t row = 0; row < tiles_along_[1]; ++row) {
    for (std::int64_t column = 0; column < tiles_along_[0]; ++column, ++number) {
      const Vec2 lower = lower_corner(column, row);
      tiles_[number].open = {lower - margin, lower + Vec2{tile_size_, tile_size_} + margin};
    }
  }
  full_.assign(words_per_row_ * rows, 0);
}

std::int64_t CoveredPicture::column_of(double coordinate, int axis) const {
  const double column = (coordinate - lower_[axis]) / tile_size_;
  if (!(column >= 0)) return -1;
  return static_cast<std::int64_t>(std::min(column, static_cast<double>(tiles_along_[axis])));
}

Vec2 CoveredPicture::lower_corner(std::int64_t column, std::int64_t row) const {
  return lower_ + tile_size_ * Vec2{static_cast<double>(column), static_cast<double>(row)};
}

void CoveredPicture::mark_full(std::int64_t column, std::int64_t row) {
  full_[static_cast<std::size_t>(row) * words_per_row_ + static_cast<std::size_t>(column / 64)] |=
      std::uint64_t{1} << (column % 64);
}

bool CoveredPicture::is_full(const Rectangle& rectangle) const {
  const std::int64_t left = std::max<std::int64_t>(column_of(rectangle.lower.x, 0), 0);
  const std::int64_t right = std::min(column_of(rectangle.upper.x, 0), tiles_along_[0] - 1);
  const std::int64_t bottom = std::max<std::int64_t>(column_of(rectangle.lower.y, 1), 0);
  const std::int64_t top = std::min(column_of(rectangle.upper.y, 1), tiles_along_[1] - 1);
  if (left > right) return true;
  for (std::int64_t row = bottom; row <= top; ++row) {
    const std::uint64_t* const words =
        full_.data() + static_cast<std::size_t>(row) * words_per_row_;
    for (std::int64_t word = left / 64; word <= right / 64; ++word) {
      std::uint64_t wanted = ~std::uint64_t{0};
      if (word == left / 64) wanted &= ~std::uint64_t{0} << (left % 64);
      if (word == right / 64) wanted &= ~std::uint64_t{0} >> (63 - right % 64);
      for (std::uint64_t open = wanted & ~words[word]; open != 0; open &= open - 1) {
        const std::int64_t column = 64 * word + std::countr_zero(open);
        const Rectangle& box =
            tiles_[static_cast<std::size_t>(row * tiles_along_[0] + column)].open;
        if (do_overlap(rectangle, box)) return false;
      }
    }
  }
  return true;
}

void CoveredPicture::cover(std::span<const Vec2> polygon, double tolerance) {
  if (polygon.size() < 3) return;
  Vec2 lower = polygon[0];
  Vec2 upper = polygon[0];
  for (const Vec2 corner : polygon) {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  const std::int64_t left = std::max<std::int64_t>(column_of(lower.x - tolerance, 0), 0);
  const std::int64_t right = std::min(column_of(upper.x + tolerance, 0), tiles_along_[0] - 1);
  const std::int64_t bottom = std::max<std::int64_t>(column_of(lower.y - tolerance, 1), 0);
  const std::int64_t top = std::min(column_of(upper.y + tolerance, 1), tiles_along_[1] - 1);
  const Vec2 beyond{tolerance, tolerance};
  const Rectangle extent{lower - beyond, upper + beyond};
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  for (std::int64_t row = bottom; row <= top; ++row) {
    for (std::int64_t column = left; column <= right; ++column) {
      if (is_full(column, row)) continue;
      if (count == 0) {
        small_count(half_planes_.size() + polygon.size(), "sides of outlines in a picture");
        first = static_cast<std::uint32_t>(half_planes_.size());
        count = static_cast<std::uint32_t>(polygon.size());
        for (std::size_t k = 0; k < polygon.size(); ++k) {
          const Vec2 from = polygon[k];
          const Vec2 to = polygon[k + 1 == polygon.size() ? 0 : k + 1];
          const Vec2 along = to - from;
          const Vec2 outwards = Vec2{along.y, -along.x} / glm::length(along);
          // Beside the viewer, ends are as far off as a million pictures: the nearer one says
          // better where the line through both is.
          const bool is_from_nearer = glm::dot(from, from) <= glm::dot(to, to);
          const Vec2 end = is_from_nearer ? from : to;
          const double rounding = kRounding * std::max(std::abs(end.x), std::abs(end.y));
          half_planes_.push_back({outwards, glm::dot(outwards, end) + tolerance + rounding});
        }
      }
      cover_tile(column, row, extent, first, count);
    }
  }
}

void CoveredPicture::cover_tile(std::int64_t column, std::int64_t row, const Rectangle& extent,
                                std::uint32_t first, std::uint32_t count) {
  const Vec2 lower = lower_corner(column, row);
  const double half = 0.5 * tile_size_;
  const Vec2 middle = lower + Vec2{half, half};
  for (std::uint32_t k = first; k < first + count; ++k) {
    const HalfPlane& side = half_planes_[k];
    if (side(middle) > half * (std::abs(side.normal.x) + std::abs(side.normal.y))) return;
  }
  Tile& tile = tiles_[static_cast<std::size_t>(row * tiles_along_[0] + column)];
  const Rectangle& open = tile.open;
  if (!do_overlap(extent, open)) return;  // it adds nothing
  // What reaches from side to side only can leave a smaller box.
  const bool may_shrink = (extent.lower.x <= open.lower.x && extent.upper.x >= open.upper.x) ||
                          (extent.lower.y <= open.lower.y && extent.upper.y >= open.upper.y);
  if (may_shrink && !shrink_open_box(tile.open, first, count)) {
    mark_full(column, row);
    return;
  }
  small_count(entries_.size() + 1, "outlines in tiles of a picture", most_entries_);
  entries_.push_back({first, count, tile.first_entry});
  tile.first_entry = static_cast<std::int32_t>(entries_.size() - 1);
  ++tile.entry_count;
  if (tile.entry_count >= kManyEntries && std::has_single_bit(tile.entry_count) &&
      is_covered_all_over(tile, lower)) {
    mark_full(column, row);
  }
}

/// What a polygon leaves of a box lies beyond its sides; false if nothing is left.
bool CoveredPicture::shrink_open_box(Rectangle& open, std::uint32_t first,
                                     std::uint32_t count) const {
  const Vec2 corners[4] = {
      open.lower, {open.upper.x, open.lower.y}, open.upper, {open.lower.x, open.upper.y}};
  Rectangle rest{open.upper, open.lower};
  const auto add = [&](Vec2 point) {
    rest.lower = glm::min(rest.lower, point);
    rest.upper = glm::max(rest.upper, point);
  };
  for (std::uint32_t k = first; k < first + count; ++k) {
    const HalfPlane& side = half_planes_[k];
    double values[4];
    for (int i = 0; i < 4; ++i) values[i] = side(corners[i]);
    if ((values[0] > 0 && values[2] > 0) || (values[1] > 0 && values[3] > 0)) return true;
    for (int i = 0; i < 4; ++i) {
      const int next = (i + 1) % 4;
      if (values[i] > 0) add(corners[i]);
      if ((values[i] > 0) != (values[next] > 0)) {
        add(corners[i] + (corners[next] - corners[i]) * (values[i] / (values[i] - values[next])));
      }
    }
  }
  if (!(rest.lower.x <= rest.upper.x && rest.lower.y <= rest.upper.y)) return false;
  open = rest;
  return true;
}

bool CoveredPicture::is_covered_all_over(const Tile& tile, Vec2 lower) {
  rest_.start(lower, tile_size_);
  for (std::int32_t number = tile.first_entry; number >= 0 && !rest_.is_empty();) {
    const Entry& entry = entries_[static_cast<std::size_t>(number)];
    rest_.take_away(half_planes(entry));
    number = entry.next;
  }
  return rest_.is_empty();
}

void CoveredPicture::find_uncovered(Vec2 a, Vec2 b, Interval part,
                                    std::vector<Interval>& uncovered) {
  const Vec2 step = b - a;
  // Within bounds first.
  for (int axis = 0; axis < 2; ++axis) {
    const double low = lower_[axis] - a[axis];
    const double high = low + tile_size_ * static_cast<double>(tiles_along_[axis]);
    if (step[axis] == 0) {
      if (low > 0 || high < 0) return;
      continue;
    }
    double enter = low / step[axis];
    double leave = high / step[axis];
    if (enter > leave) std::swap(enter, leave);
    part.begin = std::max(part.begin, enter);
    part.end = std::min(part.end, leave);
  }
  if (!(part.begin < part.end)) return;

  const auto clamped = [&](double coordinate, int axis) {
    return std::clamp<std::int64_t>(column_of(coordinate, axis), 0, tiles_along_[axis] - 1);
  };
  // Column by column (or row by row, the way in which there are fewer) of the grid.
  const int across = std::abs(step.x) < std::abs(step.y) ? 0 : 1;
  const int along = 1 - across;
  const auto at = [&](double s, int axis) { return a[axis] + s * step[axis]; };
  const std::int64_t first = clamped(at(part.begin, across), across);
  const std::int64_t last = clamped(at(part.end, across), across);
  const std::int64_t way = first <= last ? 1 : -1;
  double from = part.begin;
  for (std::int64_t i = first;; i += way) {
    double to = part.end;
    if (i != last) {
      const double border = lower_[across] + tile_size_ * static_cast<double>(way > 0 ? i + 1 : i);
      to = std::clamp((border - a[across]) / step[across], from, part.end);
    }
    const std::int64_t start = clamped(at(from, along), along);
    const std::int64_t stop = clamped(at(to, along), along);
    const std::int64_t direction = start <= stop ? 1 : -1;
    double begin = from;
    for (std::int64_t j = start;; j += direction) {
      double end = to;
      if (j != stop) {
        const double border =
            lower_[along] + tile_size_ * static_cast<double>(direction > 0 ? j + 1 : j);
        end = std::clamp((border - a[along]) / step[along], begin, to);
      }
      if (begin < end) {
        if (across == 0) {
          look_at_tile(i, j, a, step, {begin, end}, uncovered);
        } else {
          look_at_tile(j, i, a, step, {begin, end}, uncovered);
        }
      }
      begin = end;
      if (j == stop) break;
    }
    from = to;
    if (i == last) break;
  }
}

void CoveredPicture::look_at_tile(std::int64_t column, std::int64_t row, Vec2 a, Vec2 step,
                                  Interval part, std::vector<Interval>& uncovered) {
  if (is_full(column, row)) return;
  const Tile& tile = tiles_[static_cast<std::size_t>(row * tiles_along_[0] + column)];
  const Vec2 begin = a + part.begin * step;
  const Vec2 end = a + part.end * step;
  if (!do_overlap({glm::min(begin, end), glm::max(begin, end)}, tile.open)) return;
  open_.assign(1, part);
  for (std::int32_t number = tile.first_entry; number >= 0 && !open_.empty();) {
    const Entry& entry = entries_[static_cast<std::size_t>(number)];
    number = entry.next;
    Interval covered = part;
    for (const HalfPlane& side : half_planes(entry)) {
      const double start = side(a);
      const double rise = glm::dot(side.normal, step);
      const double at_begin = start + covered.begin * rise;
      const double at_end = start + covered.end * rise;
      if (at_begin > 0 && at_end > 0) {
        covered.end = covered.begin;
        break;
      }
      if (at_begin > 0) {
        covered.begin -= at_begin / rise;
      } else if (at_end > 0) {
        covered.end -= at_end / rise;
      }
    }
    if (!(covered.begin < covered.end)) continue;
    next_open_.clear();
    for (const Interval& open : open_) {
      if (open.begin < covered.begin) {
        next_open_.push_back({open.begin, std::min(open.end, covered.begin)});
      }
      if (open.end > covered.end)
        next_open_.push_back({std::max(open.begin, covered.end), open.end});
    }
    std::swap(open_, next_open_);
  }
  for (const Interval& open : open_) {
    // What goes on in the next tile is one part.
    if (!uncovered.empty() && uncovered.back().end == open.begin) {
      uncovered.back().end = open.end;
    } else {
      uncovered.push_back(open);
    }
  }
}

}  // namespace spoctree
