#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "client/lines/arrange_lines.hpp"
#include "client/lines/view.hpp"

namespace spoctree {

namespace {

/// Overlaps shorter than this many tolerances are lines that touch.
constexpr double kShortestOverlap = 4;

/// A line in the picture.
struct Trace : ProjectedLine {
  Vec2 direction{0.0};  ///< unit
  double length = 0;
};

/// A part of a line that another one takes over: parameters in the picture.
struct Cut {
  std::uint32_t line = 0;
  double begin = 0;
  double end = 0;
};

/// Which lines run through which tiles of a grid; `items_of` a tile are ascending.
class TraceGrid {
 public:
  TraceGrid(const std::vector<Trace>& traces, double margin) : margin_(margin) {
    Vec2 lower = traces.front().a;
    Vec2 upper = lower;
    for (const Trace& trace : traces) {
      lower = glm::min(lower, glm::min(trace.a, trace.b));
      upper = glm::max(upper, glm::max(trace.a, trace.b));
    }
    lower_ = lower;
    const double wanted = std::sqrt(static_cast<double>(traces.size()));
    side_ = static_cast<std::uint32_t>(std::clamp(wanted, 1.0, 2048.0));
    size_ = std::max({upper.x - lower.x, upper.y - lower.y, margin}) / side_;
    begin_.assign(std::size_t{side_} * side_ + 1, 0);
    for (const Trace& trace : traces) {
      for_each_tile(trace, [&](std::size_t tile) { ++begin_[tile + 1]; });
    }
    for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
    items_.resize(begin_.back());
    std::vector<std::size_t> fill(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t line = 0; line < traces.size(); ++line) {
      for_each_tile(traces[line], [&](std::size_t tile) { items_[fill[tile]++] = line; });
    }
  }

  std::size_t tile_count() const { return begin_.size() - 1; }
  std::span<const std::uint32_t> items_of(std::size_t tile) const {
    return {items_.data() + begin_[tile], begin_[tile + 1] - begin_[tile]};
  }

 private:
  std::uint32_t column_of(double coordinate, int axis) const {
    const double column = std::floor((coordinate - lower_[axis]) / size_);
    return static_cast<std::uint32_t>(std::clamp(column, 0.0, side_ - 1.0));
  }

  /// Row by row: the columns that the line, widened by the margin, meets there.
  template <class Visit>
  void for_each_tile(const Trace& trace, Visit&& visit) const {
    const Vec2 low = trace.a.y <= trace.b.y ? trace.a : trace.b;
    const Vec2 high = trace.a.y <= trace.b.y ? trace.b : trace.a;
    const std::uint32_t first_row = column_of(low.y - margin_, 1);
    const std::uint32_t last_row = column_of(high.y + margin_, 1);
    for (std::uint32_t row = first_row; row <= last_row; ++row) {
      double from = low.x;
      double to = high.x;
      if (first_row != last_row && high.y > low.y) {
        const double slope = (high.x - low.x) / (high.y - low.y);
        const double bottom = lower_.y + row * size_ - margin_;
        from = low.x + slope * std::clamp(bottom - low.y, 0.0, high.y - low.y);
        to = low.x + slope * std::clamp(bottom + size_ + 2 * margin_ - low.y, 0.0, high.y - low.y);
      }
      const std::uint32_t last = column_of(std::max(from, to) + margin_, 0);
      for (std::uint32_t column = column_of(std::min(from, to) - margin_, 0); column <= last;
           ++column) {
        visit(std::size_t{row} * side_ + column);
      }
    }
  }

  Vec2 lower_;
  double margin_;
  double size_ = 1;
  std::uint32_t side_ = 1;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> items_;
};

class OverlapFinder {
 public:
  OverlapFinder(const VisibleLines& lines, const std::vector<Trace>& traces, const Camera& camera,
                double tolerance)
      : lines_(lines), traces_(traces), camera_(camera), tolerance_(tolerance) {}

  void compare(std::uint32_t p, std::uint32_t q) {
    if (traces_[p].length < traces_[q].length) std::swap(p, q);
    const Trace& longer = traces_[p];
    const Trace& shorter = traces_[q];
    const double cross =
        longer.direction.x * shorter.direction.y - longer.direction.y * shorter.direction.x;
    if (std::abs(cross) * shorter.length > 2 * tolerance_) return;
    const Vec2 normal{-longer.direction.y, longer.direction.x};
    if (std::abs(glm::dot(normal, shorter.a - longer.a)) > tolerance_ ||
        std::abs(glm::dot(normal, shorter.b - longer.a)) > tolerance_) {
      return;
    }
    const double at_a = glm::dot(longer.direction, shorter.a - longer.a);
    const double at_b = glm::dot(longer.direction, shorter.b - longer.a);
    const double begin = std::max(0.0, std::min(at_a, at_b));
    const double end = std::min(longer.length, std::max(at_a, at_b));
    if (end - begin < kShortestOverlap * tolerance_) return;
    // The same stretch as parameters of either line.
    const double on_longer[2] = {begin / longer.length, end / longer.length};
    double on_shorter[2] = {(begin - at_a) / (at_b - at_a), (end - at_a) / (at_b - at_a)};
    if (on_shorter[0] > on_shorter[1]) std::swap(on_shorter[0], on_shorter[1]);
    if (goes_before(p, 0.5 * (on_longer[0] + on_longer[1]), q,
                    0.5 * (on_shorter[0] + on_shorter[1]))) {
      cuts.push_back({q, on_shorter[0], on_shorter[1]});
    } else {
      cuts.push_back({p, on_longer[0], on_longer[1]});
    }
  }

  std::vector<Cut> cuts;

 private:
  bool goes_before(std::uint32_t p, double at_p, std::uint32_t q, double at_q) const {
    if (lines_[p].hidden != lines_[q].hidden) return lines_[q].hidden;
    const auto nearness = [&](std::uint32_t line, double t) {
      return camera_.nearness(lines_[line].a +
                              traces_[line].to_space(t) * (lines_[line].b - lines_[line].a));
    };
    const double ahead = nearness(p, at_p) - nearness(q, at_q);
    return std::abs(ahead) > tolerance_ ? ahead > 0 : p < q;
  }

  const VisibleLines& lines_;
  const std::vector<Trace>& traces_;
  const Camera& camera_;
  double tolerance_;
};

}  // namespace

VisibleLines remove_overlaps(const VisibleLines& lines, const Camera& camera, double tolerance) {
  if (lines.empty()) return {};
  std::vector<Trace> traces;
  traces.reserve(lines.size());
  for (const VisibleLine& line : lines) {
    Trace trace{project(line.a, line.b, camera)};
    trace.length = glm::distance(trace.a, trace.b);
    if (trace.length > 0) trace.direction = (trace.b - trace.a) / trace.length;
    traces.push_back(trace);
  }
  OverlapFinder finder(lines, traces, camera, tolerance);
  const TraceGrid grid(traces, tolerance);
  for (std::size_t tile = 0; tile < grid.tile_count(); ++tile) {
    const auto items = grid.items_of(tile);
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t j = i + 1; j < items.size(); ++j) finder.compare(items[i], items[j]);
    }
  }
  std::sort(finder.cuts.begin(), finder.cuts.end(), [](const Cut& p, const Cut& q) {
    return p.line != q.line ? p.line < q.line : p.begin < q.begin;
  });

  VisibleLines result;
  auto cut = finder.cuts.begin();
  for (std::uint32_t k = 0; k < lines.size(); ++k) {
    const double shortest = kShortestOverlap * tolerance / std::max(traces[k].length, tolerance);
    double from = 0;
    const auto keep_until = [&](double to) {
      if (to - from < shortest && (from > 0 || to < 1)) return;
      VisibleLine part = lines[k];
      const auto at = [&](double s) {
        return lines[k].a + traces[k].to_space(s) * (lines[k].b - lines[k].a);
      };
      if (from > 0) part.a = at(from);
      if (to < 1) part.b = at(to);
      result.push_back(part);
    };
    for (; cut != finder.cuts.end() && cut->line == k; ++cut) {
      keep_until(cut->begin);
      from = std::max(from, cut->end);
    }
    keep_until(1);
  }
  return result;
}

}  // namespace spoctree
