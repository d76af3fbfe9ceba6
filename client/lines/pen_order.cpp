#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "client/lines/arrange_lines.hpp"

namespace spoctree {

namespace {

constexpr auto kNone = static_cast<std::uint32_t>(-1);

/// Line ends not drawn yet, by place; gives the nearest to the pen and forgets lines. The grid is
/// made anew, coarser, whenever three quarters of the lines are gone.
class EndsLeft {
 public:
  EndsLeft(std::vector<std::uint32_t> lines, const std::vector<Vec2>& ends)
      : ends_(ends), lines_(std::move(lines)), is_drawn_(ends.size() / 2, true) {
    for (const std::uint32_t line : lines_) is_drawn_[line] = false;
    build();
  }

  bool is_empty() const { return left_ == 0; }

  void forget(std::uint32_t line) {
    is_drawn_[line] = true;
    --left_;
    if (left_ > 0 && 4 * left_ <= lines_.size()) {
      std::erase_if(lines_, [&](std::uint32_t k) { return is_drawn_[k]; });
      build();
    }
  }

  /// The nearest end; of equally near ones that of the lowest number. Searches ring by ring.
  /// REQUIRES: not empty.
  std::uint32_t nearest(Vec2 pen) {
    const auto column = static_cast<std::int64_t>(column_of(pen.x, 0));
    const auto row = static_cast<std::int64_t>(column_of(pen.y, 1));
    const auto side = static_cast<std::int64_t>(side_);
    double best = std::numeric_limits<double>::infinity();
    std::uint32_t found = kNone;
    const auto look = [&](std::int64_t x, std::int64_t y) {
      if (x < 0 || y < 0 || x >= side || y >= side) return;
      const auto tile = static_cast<std::size_t>(y * side + x);
      std::size_t& first = first_left_[tile];
      while (first < begin_[tile + 1] && is_drawn_[items_[first] / 2]) ++first;
      for (std::size_t k = first; k < begin_[tile + 1] && best > 0; ++k) {
        const std::uint32_t end = items_[k];
        if (is_drawn_[end / 2]) continue;
        const double distance = glm::distance(ends_[end], pen);
        if (distance < best || (distance == best && end < found)) {
          best = distance;
          found = end;
        }
      }
    };
    for (std::int64_t ring = 0; ring <= side; ++ring) {
      // Everything in this ring is at least ring - 1 tiles away.
      if (best < static_cast<double>(ring - 1) * size_) break;
      for (std::int64_t y = row - ring; y <= row + ring; ++y) {
        const bool whole_row = y == row - ring || y == row + ring;
        for (std::int64_t x = column - ring; x <= column + ring;
             x += whole_row || ring == 0 ? 1 : 2 * ring) {
          look(x, y);
        }
      }
    }
    return found;
  }

 private:
  void build() {
    left_ = lines_.size();
    if (left_ == 0) return;
    lower_ = ends_[2 * lines_.front()];
    Vec2 upper = lower_;
    for (const std::uint32_t line : lines_) {
      for (const std::uint32_t end : {2 * line, 2 * line + 1}) {
        lower_ = glm::min(lower_, ends_[end]);
        upper = glm::max(upper, ends_[end]);
      }
    }
    side_ =
        static_cast<std::uint32_t>(std::clamp(std::sqrt(static_cast<double>(left_)), 1.0, 2048.0));
    const double extent = std::max(upper.x - lower_.x, upper.y - lower_.y);
    size_ = extent > 0 ? extent / side_ : 1;
    begin_.assign(std::size_t{side_} * side_ + 1, 0);
    const auto tile_of = [&](std::uint32_t end) {
      return std::size_t{column_of(ends_[end].y, 1)} * side_ + column_of(ends_[end].x, 0);
    };
    for (const std::uint32_t line : lines_) {
      ++begin_[tile_of(2 * line) + 1];
      ++begin_[tile_of(2 * line + 1) + 1];
    }
    for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
    items_.resize(begin_.back());
    std::vector<std::size_t> fill(begin_.begin(), begin_.end() - 1);
    first_left_.assign(begin_.begin(), begin_.end() - 1);
    for (const std::uint32_t line : lines_) {
      for (const std::uint32_t end : {2 * line, 2 * line + 1}) items_[fill[tile_of(end)]++] = end;
    }
  }

  std::uint32_t column_of(double coordinate, int axis) const {
    const double column = std::floor((coordinate - lower_[axis]) / size_);
    return static_cast<std::uint32_t>(std::clamp(column, 0.0, side_ - 1.0));
  }

  const std::vector<Vec2>& ends_;
  std::vector<std::uint32_t> lines_;
  std::vector<bool> is_drawn_;
  std::size_t left_ = 0;
  Vec2 lower_{0.0};
  double size_ = 1;
  std::uint32_t side_ = 1;
  std::vector<std::size_t> begin_;
  std::vector<std::size_t> first_left_;  // per tile: what stands before it has been drawn
  std::vector<std::uint32_t> items_;
};

Vec2 first_place(const std::vector<Vec2>& ends) {
  Vec2 pen{0.0};
  for (const Vec2 end : ends) pen = glm::min(pen, end);
  return pen;
}

/// Calls visit(end) for all of the lines, in the order in which and at the ends at which a pen at
/// `pen` should begin them; moves the pen.
template <class Visit>
void visit_in_order(std::vector<std::uint32_t> lines, const std::vector<Vec2>& ends, Vec2& pen,
                    Visit&& visit) {
  EndsLeft left(std::move(lines), ends);
  while (!left.is_empty()) {
    const std::uint32_t end = left.nearest(pen);
    visit(end);
    pen = ends[end ^ 1];
    left.forget(end / 2);
  }
}

}  // namespace

std::vector<std::uint32_t> pen_order(const std::vector<Vec2>& ends) {
  std::vector<std::uint32_t> lines(ends.size() / 2);
  std::iota(lines.begin(), lines.end(), 0);
  std::vector<std::uint32_t> order;
  order.reserve(lines.size());
  Vec2 pen = first_place(ends);
  visit_in_order(std::move(lines), ends, pen, [&](std::uint32_t end) { order.push_back(end); });
  return order;
}

VisibleLines in_pen_order(VisibleLines lines, const Camera& camera, const ProgressShare& progress) {
  std::vector<Vec2> ends;
  ends.reserve(2 * lines.size());
  for (const VisibleLine& line : lines) {
    ends.push_back(camera.project(line.a));
    ends.push_back(camera.project(line.b));
  }
  Vec2 pen = first_place(ends);

  const auto layer_of = [](const VisibleLine& line) {
    return line.hidden ? 0 : (line.kind == LineKind::Crease ? 1 : 2);
  };
  ProgressCounter counter(progress);
  VisibleLines result;
  result.reserve(lines.size());
  for (int layer = 0; layer < 3; ++layer) {
    std::vector<std::uint32_t> members;
    for (std::uint32_t k = 0; k < lines.size(); ++k) {
      if (layer_of(lines[k]) == layer) members.push_back(k);
    }
    visit_in_order(std::move(members), ends, pen, [&](std::uint32_t end) {
      counter.add(per_item(lines.size()));
      VisibleLine& line = lines[end / 2];
      if (end % 2 == 1) reverse(line);
      result.push_back(std::move(line));
    });
  }
  return result;
}

}  // namespace spoctree
