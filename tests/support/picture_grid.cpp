#include "tests/support/picture_grid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace spoctree {

namespace {

using glm::dvec2;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

PictureGrid::PictureGrid(const std::vector<PictureOutline>& outlines, double pad,
                         double half_width) {
  dvec2 lower{kInfinity};
  dvec2 upper{-kInfinity};
  for (const PictureOutline& outline : outlines) {
    for (std::uint32_t k = 0; k < outline.count; ++k) {
      const dvec2 p = glm::clamp(outline.corners[k], -half_width, half_width);
      lower = glm::min(lower, p);
      upper = glm::max(upper, p);
    }
  }
  stamp_.assign(outlines.size(), 0);
  if (outlines.empty()) lower = upper = dvec2{0.0};
  lower_ = lower;
  const dvec2 size = glm::max(upper - lower, 1e-300);
  const double along = std::clamp(std::sqrt(static_cast<double>(outlines.size())), 1.0, 1000.0);
  cell_ = std::max(size.x, size.y) / along;
  columns_ = static_cast<std::uint32_t>(size.x / cell_) + 1;
  rows_ = static_cast<std::uint32_t>(size.y / cell_) + 1;
  std::vector<std::uint32_t> counts(std::size_t{columns_} * rows_ + 1, 0);
  for (const PictureOutline& outline : outlines) {
    for_cells(outline, pad, [&](std::size_t cell) { ++counts[cell + 1]; });
  }
  for (std::size_t k = 1; k < counts.size(); ++k) counts[k] += counts[k - 1];
  begin_ = counts;
  items_.resize(counts.back());
  for (std::uint32_t k = 0; k < outlines.size(); ++k) {
    for_cells(outlines[k], pad, [&](std::size_t cell) { items_[counts[cell]++] = k; });
  }
}

/// Row by row: the part of the outline in the row's band, and the columns between its ends.
template <class Visit>
void PictureGrid::for_cells(const PictureOutline& outline, double pad, const Visit& visit) const {
  const double hair = pad + 1e-6 * cell_;
  const auto index = [&](double at, double low, std::uint32_t count) {
    return static_cast<std::uint32_t>(
        std::clamp(std::floor((at - low) / cell_), 0.0, static_cast<double>(count - 1)));
  };
  double low = kInfinity;
  double high = -kInfinity;
  for (std::uint32_t k = 0; k < outline.count; ++k) {
    low = std::min(low, outline.corners[k].y);
    high = std::max(high, outline.corners[k].y);
  }
  const std::uint32_t last = index(high + hair, lower_.y, rows_);
  for (std::uint32_t row = index(low - hair, lower_.y, rows_); row <= last; ++row) {
    // What lies beyond the first and the last row counts as in them.
    const double from = row == 0 ? -kInfinity : lower_.y + row * cell_ - hair;
    const double to = row + 1 == rows_ ? kInfinity : lower_.y + (row + 1) * cell_ + hair;
    double left = kInfinity;
    double right = -kInfinity;
    const auto include = [&](double x) {
      left = std::min(left, x);
      right = std::max(right, x);
    };
    for (std::uint32_t k = 0; k < outline.count; ++k) {
      const dvec2 p = outline.corners[k];
      const dvec2 q = outline.corners[(k + 1) % outline.count];
      if (p.y >= from && p.y <= to) include(p.x);
      for (const double wall : {from, to}) {
        if ((p.y < wall) == (q.y < wall) || !std::isfinite(wall)) continue;
        include(p.x + (q.x - p.x) * std::clamp((wall - p.y) / (q.y - p.y), 0.0, 1.0));
      }
    }
    if (left > right) continue;
    const std::uint32_t end = index(right + hair, lower_.x, columns_);
    for (std::uint32_t column = index(left - hair, lower_.x, columns_); column <= end; ++column) {
      visit(std::size_t{row} * columns_ + column);
    }
  }
}

const std::vector<std::uint32_t>& PictureGrid::near(const PictureOutline& place) {
  ++round_;
  found_.clear();
  for_cells(place, 0, [&](std::size_t cell) {
    for (std::uint32_t k = begin_[cell]; k < begin_[cell + 1]; ++k) {
      if (stamp_[items_[k]] == round_) continue;
      stamp_[items_[k]] = round_;
      found_.push_back(items_[k]);
    }
  });
  return found_;
}

}  // namespace spoctree
