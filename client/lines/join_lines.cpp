#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "client/lines/arrange_lines.hpp"

namespace spoctree {

namespace {

/// Where more line ends than this meet, none of them are joined: it is looks only, and it keeps
/// hostile input from costing the square of its size.
constexpr std::size_t kMostEndsAtOnePoint = 256;

constexpr auto kNone = static_cast<std::uint32_t>(-1);

/// Distance of `point` from the straight line through a and b.
double distance_from_line(Vec3 point, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double length = glm::length(along);
  if (length == 0) return glm::distance(point, a);
  return glm::length(glm::cross(along, point - a)) / length;
}

/// The ends of lines by place. End 2 i is line i's `a`, end 2 i + 1 its `b`.
class Ends {
 public:
  Ends(const VisibleLines& lines, double tolerance)
      : lines_(lines), tolerance_(tolerance), cell_size_(64 * tolerance) {
    std::size_t size = 16;
    while (size < 4 * lines.size()) size *= 2;
    first_.assign(size, kNone);
    next_.assign(2 * lines.size(), kNone);
    for (auto end = static_cast<std::uint32_t>(next_.size()); end-- > 0;) {
      std::uint32_t& slot = first_[slot_of(cell_of(at(end)))];
      next_[end] = slot;
      slot = end;
    }
  }

  Vec3 at(std::uint32_t end) const {
    const VisibleLine& line = lines_[end / 2];
    return end % 2 == 0 ? line.a : line.b;
  }

  /// All other ends nearer than the tolerance, by ascending number.
  void find_near(std::uint32_t end, std::vector<std::uint32_t>& near) const {
    near.clear();
    const Vec3 point = at(end);
    const Cell cell = cell_of(point - Vec3{tolerance_, tolerance_, tolerance_});
    const Cell last = cell_of(point + Vec3{tolerance_, tolerance_, tolerance_});
    for (std::int64_t x = cell.x; x <= last.x; ++x) {
      for (std::int64_t y = cell.y; y <= last.y; ++y) {
        for (std::int64_t z = cell.z; z <= last.z; ++z) {
          for (std::uint32_t k = first_[slot_of({x, y, z})]; k != kNone; k = next_[k]) {
            if (k == end || glm::distance(at(k), point) > tolerance_) continue;
            near.push_back(k);
            if (near.size() > kMostEndsAtOnePoint) return;
          }
        }
      }
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
  Cell cell_of(Vec3 point) const {
    const Vec3 scaled = glm::floor(point / cell_size_);
    return {static_cast<std::int64_t>(scaled.x), static_cast<std::int64_t>(scaled.y),
            static_cast<std::int64_t>(scaled.z)};
  }
  std::size_t slot_of(Cell cell) const {
    auto hash = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15u;
    hash = (hash ^ (hash >> 29) ^ static_cast<std::uint64_t>(cell.y)) * 0xBF58476D1CE4E5B9u;
    hash = (hash ^ (hash >> 32) ^ static_cast<std::uint64_t>(cell.z)) * 0x94D049BB133111EBu;
    return static_cast<std::size_t>(hash ^ (hash >> 31)) & (first_.size() - 1);
  }

  const VisibleLines& lines_;
  double tolerance_;
  double cell_size_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> next_;
};

/// For each end, the end of the line that continues its own straight on, or kNone.
std::vector<std::uint32_t> find_partners(const VisibleLines& lines, double tolerance,
                                         const ProgressShare& progress) {
  ProgressCounter counter(progress);
  const Ends ends(lines, tolerance);
  const auto count = static_cast<std::uint32_t>(2 * lines.size());
  std::vector<std::uint32_t> choice(count, kNone);
  std::vector<std::uint32_t> near;
  for (std::uint32_t end = 0; end < count; ++end) {
    counter.add(per_item(count));
    ends.find_near(end, near);
    if (near.size() > kMostEndsAtOnePoint) continue;
    const VisibleLine& line = lines[end / 2];
    const Vec3 joint = ends.at(end);
    const Vec3 far = ends.at(end ^ 1);
    double straightest = 0;
    for (const std::uint32_t other : near) {
      const VisibleLine& next = lines[other / 2];
      if (other / 2 == end / 2 || next.kind != line.kind || next.hidden != line.hidden ||
          next.is_step != line.is_step) {
        continue;
      }
      const Vec3 other_far = ends.at(other ^ 1);
      const Vec3 before = joint - far;
      const Vec3 after = other_far - joint;
      const double straight = glm::dot(before, after) / (glm::length(before) * glm::length(after));
      if (!(straight > straightest) || distance_from_line(joint, far, other_far) > tolerance) {
        continue;
      }
      straightest = straight;
      choice[end] = other;
    }
  }
  std::vector<std::uint32_t> partners(count, kNone);
  for (std::uint32_t end = 0; end < count; ++end) {
    if (choice[end] != kNone && choice[choice[end]] == end) partners[end] = choice[end];
  }
  return partners;
}

/// A chain of lines, point by point, as few lines as the tolerance allows (Douglas and Peucker).
class Straightener {
 public:
  Straightener(const VisibleLines& lines, double tolerance, VisibleLines& result)
      : lines_(lines), tolerance_(tolerance), result_(result) {}

  void start(Vec3 point) {
    points_.assign(1, point);
    links_.clear();
  }
  /// `end` is an end of a line, as in Ends: the other end of the line has just been reached.
  void append(std::uint32_t end, Vec3 point) {
    links_.push_back(end);
    points_.push_back(point);
  }
  void finish() {
    todo_.assign(1, {0, links_.size()});
    while (!todo_.empty()) {
      const auto [first, last] = todo_.back();
      todo_.pop_back();
      double farthest = 0;
      std::size_t at = first;
      for (std::size_t k = first + 1; k < last; ++k) {
        const double distance = distance_from_line(points_[k], points_[first], points_[last]);
        if (distance <= farthest) continue;
        farthest = distance;
        at = k;
      }
      if (farthest > tolerance_) {
        todo_.push_back({at, last});
        todo_.push_back({first, at});
      } else {
        emit(first, last);
      }
    }
  }

 private:
  void emit(std::size_t first, std::size_t last) {
    VisibleLine line = lines_[links_[first] / 2];
    line.a = points_[first];
    line.b = points_[last];
    if (last - first == 1) {
      if (links_[first] % 2 == 0) line = reversed(lines_[links_[first] / 2]);
    } else {
      append_stretches(line, first, last);
    }
    result_.push_back(line);
  }

  /// What the links between two points have for stretches becomes the joined line's.
  void append_stretches(VisibleLine& line, std::size_t first, std::size_t last) {
    const Vec3 way = line.b - line.a;
    const auto at = [&](Vec3 point) { return glm::dot(point - line.a, way) / glm::dot(way, way); };
    std::vector<LineStretch> stretches;
    for (std::size_t k = first; k < last; ++k) {
      const VisibleLine& next = lines_[links_[k] / 2];
      const double begin = at(points_[k]);
      const double end = k + 1 == last ? 1 : at(points_[k + 1]);
      for (LineStretch stretch : stretches_of(links_[k] % 2 == 0 ? reversed(next) : next)) {
        stretch.end = stretch.end == 1 ? end : begin + stretch.end * (end - begin);
        stretches.push_back(stretch);
      }
    }
    set_stretches(line, stretches);
  }

  const VisibleLines& lines_;
  double tolerance_;
  VisibleLines& result_;
  std::vector<Vec3> points_;
  std::vector<std::uint32_t> links_;  // the end of a line that is point k + 1
  std::vector<std::pair<std::size_t, std::size_t>> todo_;
};

}  // namespace

VisibleLines join_lines(const VisibleLines& lines, double tolerance,
                        const ProgressShare& progress) {
  const std::vector<std::uint32_t> partners = find_partners(lines, tolerance, progress);
  VisibleLines result;
  result.reserve(lines.size());
  Straightener straightener(lines, tolerance, result);
  std::vector<bool> done(lines.size(), false);
  const auto follow = [&](std::uint32_t end) {
    const auto at = [&](std::uint32_t e) { return e % 2 == 0 ? lines[e / 2].a : lines[e / 2].b; };
    straightener.start(at(end));
    while (end != kNone && !done[end / 2]) {
      done[end / 2] = true;
      straightener.append(end ^ 1, at(end ^ 1));
      end = partners[end ^ 1];
    }
    straightener.finish();
  };
  for (std::uint32_t end = 0; end < partners.size(); ++end) {
    if (partners[end] == kNone && !done[end / 2]) follow(end);
  }
  // What is left runs round in circles, which only lines of the tolerance's size can.
  for (std::uint32_t line = 0; line < lines.size(); ++line) {
    if (!done[line]) follow(2 * line);
  }
  return result;
}

}  // namespace spoctree
