#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "client/lines/arrange_lines.hpp"
#include "client/lines/view.hpp"
#include "common/base/small_count.hpp"

namespace spoctree {

namespace {

/// Overlaps shorter than this fraction of the tolerance are lines that touch.
constexpr double kShortestOverlap = 0.01;

/// What is left of a line that is shorter than this many tolerances is dropped.
constexpr double kShortestRest = 1;

/// A line in the picture.
struct Trace {
  Vec2 a{0.0};
  Vec2 b{0.0};
  Vec2 direction{0.0};  ///< unit
  double length = 0;
};

/// What has been kept so far, by the tiles of a grid that it runs through.
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
    first_.assign(std::size_t{side_} * side_, kNone);
  }

  void add(const Trace& trace, std::uint32_t item) {
    for_each_tile(trace, [&](std::size_t tile) {
      small_count(entries_.size() + 1, "lines in tiles of a picture", kMostIn32Bits - 1);
      entries_.push_back({item, first_[tile]});
      first_[tile] = static_cast<std::uint32_t>(entries_.size() - 1);
    });
  }

  /// Calls visit(item) for all that run through a tile of the line's; for some more than once.
  template <class Visit>
  void visit_near(const Trace& trace, Visit&& visit) const {
    for_each_tile(trace, [&](std::size_t tile) {
      for (std::uint32_t k = first_[tile]; k != kNone; k = entries_[k].next) {
        visit(entries_[k].item);
      }
    });
  }

 private:
  static constexpr auto kNone = static_cast<std::uint32_t>(-1);

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

  struct Entry {
    std::uint32_t item;
    std::uint32_t next;
  };

  Vec2 lower_;
  double margin_;
  double size_ = 1;
  std::uint32_t side_ = 1;
  std::vector<std::uint32_t> first_;  // by tile
  std::vector<Entry> entries_;
};

/// Where a kept line lies on another one, as a part of that one; empty where it does not.
Interval overlap(const Trace& line, const Trace& kept, double tolerance) {
  const bool line_is_longer = line.length >= kept.length;
  const Trace& longer = line_is_longer ? line : kept;
  const Trace& shorter = line_is_longer ? kept : line;
  const double cross =
      longer.direction.x * shorter.direction.y - longer.direction.y * shorter.direction.x;
  if (std::abs(cross) * shorter.length > 2 * tolerance) return {};
  const Vec2 normal{-longer.direction.y, longer.direction.x};
  if (std::abs(glm::dot(normal, shorter.a - longer.a)) > tolerance ||
      std::abs(glm::dot(normal, shorter.b - longer.a)) > tolerance) {
    return {};
  }
  const double at_a = glm::dot(longer.direction, shorter.a - longer.a);
  const double at_b = glm::dot(longer.direction, shorter.b - longer.a);
  const double begin = std::max(0.0, std::min(at_a, at_b));
  const double end = std::min(longer.length, std::max(at_a, at_b));
  if (end - begin < kShortestOverlap * tolerance) return {};
  if (line_is_longer) return {begin / longer.length, end / longer.length};
  Interval on_shorter{(begin - at_a) / (at_b - at_a), (end - at_a) / (at_b - at_a)};
  if (on_shorter.begin > on_shorter.end) std::swap(on_shorter.begin, on_shorter.end);
  return on_shorter;
}

/// The best lines first: visible ones, of these the silhouettes, and of these the nearest.
std::vector<std::uint32_t> in_order(const VisibleLines& lines, const Camera& camera) {
  std::vector<double> nearness;
  nearness.reserve(lines.size());
  for (const VisibleLine& line : lines) {
    nearness.push_back(camera.nearness(0.5 * (line.a + line.b)));
  }
  std::vector<std::uint32_t> order(lines.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::uint32_t p, std::uint32_t q) {
    if (lines[p].hidden != lines[q].hidden) return lines[q].hidden;
    if (lines[p].kind != lines[q].kind) return lines[p].kind == LineKind::Silhouette;
    return nearness[p] != nearness[q] ? nearness[p] > nearness[q] : p < q;
  });
  return order;
}

Trace trace_of(Vec2 a, Vec2 b) {
  Trace trace{a, b};
  trace.length = glm::distance(a, b);
  if (trace.length > 0) trace.direction = (b - a) / trace.length;
  return trace;
}

/// A part of a line, as parameters in the picture.
struct Part {
  std::uint32_t line;
  Interval interval;
};

}  // namespace

VisibleLines remove_overlaps(VisibleLines lines, const Camera& camera, double tolerance,
                             const ProgressShare& progress) {
  if (lines.empty()) return {};
  std::vector<Trace> traces;
  traces.reserve(lines.size());
  for (const VisibleLine& line : lines) {
    const ProjectedLine projected = project(line.a, line.b, camera);
    traces.push_back(trace_of(projected.a, projected.b));
  }

  // Each line in turn keeps what no line before it has kept: nothing is lost, nothing twice.
  std::vector<Part> kept;
  std::vector<Trace> kept_traces;
  std::vector<std::uint32_t> seen_by;
  kept.reserve(lines.size());
  kept_traces.reserve(lines.size());
  seen_by.reserve(lines.size());
  TraceGrid grid(traces, tolerance);
  std::vector<Interval> taken;
  ProgressCounter counter(progress);
  for (const std::uint32_t k : in_order(lines, camera)) {
    counter.add(per_item(lines.size()));
    const Trace& trace = traces[k];
    taken.clear();
    grid.visit_near(trace, [&](std::uint32_t item) {
      if (std::exchange(seen_by[item], k) == k) return;
      const Interval covered = overlap(trace, kept_traces[item], tolerance);
      if (covered.begin < covered.end) taken.push_back(covered);
    });
    std::sort(taken.begin(), taken.end(),
              [](const Interval& p, const Interval& q) { return p.begin < q.begin; });
    const double shortest = kShortestRest * tolerance / std::max(trace.length, tolerance);
    double from = 0;
    const auto keep_until = [&](double to) {
      const bool is_whole = from == 0 && to == 1;
      if (to - from < shortest && !is_whole) return;
      const Vec2 way = trace.b - trace.a;
      kept_traces.push_back(is_whole ? trace : trace_of(trace.a + from * way, trace.a + to * way));
      grid.add(kept_traces.back(), static_cast<std::uint32_t>(kept.size()));
      kept.push_back({k, {from, to}});
      seen_by.push_back(k);
    };
    for (const Interval& covered : taken) {
      keep_until(covered.begin);
      from = std::max(from, covered.end);
    }
    keep_until(1);
  }
  std::stable_sort(kept.begin(), kept.end(),
                   [&](const Part& p, const Part& q) { return p.line < q.line; });
  VisibleLines result;
  result.reserve(kept.size());
  for (const Part& part : kept) {
    VisibleLine& line = lines[part.line];
    if (part.interval.begin == 0 && part.interval.end == 1) {
      result.push_back(std::move(line));
      continue;
    }
    const ProjectedLine projected = project(line.a, line.b, camera);
    const auto in_space = [&](double s) { return s > 0 && s < 1 ? projected.to_space(s) : s; };
    result.push_back(cut(line, in_space(part.interval.begin), in_space(part.interval.end)));
  }
  return result;
}

}  // namespace spoctree
