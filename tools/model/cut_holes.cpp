#include "tools/model/cut_holes.hpp"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

namespace spoctree::model {

namespace {

/// A face to be cut; its corners are indices of `Drawing::corners`, too.
struct Region {
  Loop outer;
  std::vector<Loop> holes;
};

/// The corners in the coordinate plane in which the face looks largest, seen from outside.
struct Drawing {
  std::vector<glm::dvec2> corners;

  Drawing(const std::vector<glm::dvec3>& points, const Loop& outer) {
    glm::dvec3 normal{0.0};
    for (std::size_t i = 0; i < outer.size(); ++i)
      normal += glm::cross(points[outer[i]], points[outer[(i + 1) % outer.size()]]);
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
    const int right = (axis + 1) % 3;
    const int up = (axis + 2) % 3;
    corners.reserve(points.size());
    for (const glm::dvec3& point : points)
      corners.emplace_back(normal[axis] > 0 ? point[right] : -point[right], point[up]);
  }

  /// Positive where a, b, c turn left.
  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const glm::dvec2 ab = corners[b] - corners[a];
    const glm::dvec2 ac = corners[c] - corners[a];
    return ab.x * ac.y - ab.y * ac.x;
  }

  /// `point` lies on the closed segment ab.
  bool on_segment(std::uint32_t point, std::uint32_t a, std::uint32_t b) const {
    return turn(a, b, point) == 0 &&
           glm::dot(corners[a] - corners[point], corners[b] - corners[point]) <= 0;
  }

  /// Two segments have a point in common other than an end of both.
  bool collide(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    if (a == c || a == d) return on_segment(a == c ? d : c, a, b) || on_segment(b, c, d);
    if (b == c || b == d) return on_segment(b == c ? d : c, a, b) || on_segment(a, c, d);
    if (on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b))
      return true;
    return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
  }

  bool collides_with_loop(std::uint32_t a, std::uint32_t b, const Loop& loop) const {
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (collide(a, b, loop[i], loop[(i + 1) % loop.size()])) return true;
    return false;
  }

  /// The open segment ab runs through the region's inside. It need not be asked on which side of
  /// its loop it starts: a segment between two loops that starts wrongly has to cross one of them.
  bool is_cut(std::uint32_t a, std::uint32_t b, const Region& region) const {
    if (collides_with_loop(a, b, region.outer)) return false;
    for (const Loop& hole : region.holes)
      if (collides_with_loop(a, b, hole)) return false;
    return true;
  }

  double length(std::uint32_t a, std::uint32_t b) const {
    return glm::distance(corners[a], corners[b]);
  }

  /// The even-odd rule for a point that is not on the loop.
  bool is_inside(std::uint32_t point, const Loop& loop) const {
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      std::uint32_t low = loop[i];
      std::uint32_t high = loop[(i + 1) % loop.size()];
      if (corners[low].y > corners[high].y) std::swap(low, high);
      if (corners[low].y <= corners[point].y && corners[point].y < corners[high].y)
        inside ^= turn(low, high, point) > 0;
    }
    return inside;
  }
};

/// Positions in the outer loop and in the loop of the hole.
struct Cut {
  std::size_t outer;
  std::size_t hole;
};

/// The shortest cut from the corner at `at` of the hole that does not collide with `other`.
std::optional<Cut> shortest_cut(const Drawing& drawing, const Region& region, const Loop& hole,
                                std::size_t at, const std::optional<Cut>& other) {
  std::optional<Cut> best;
  for (std::size_t i = 0; i < region.outer.size(); ++i) {
    const std::uint32_t a = region.outer[i];
    if (other && (other->outer == i ||
                  drawing.collide(a, hole[at], region.outer[other->outer], hole[other->hole])))
      continue;
    if (best && drawing.length(a, hole[at]) >= drawing.length(region.outer[best->outer], hole[at]))
      continue;
    if (drawing.is_cut(a, hole[at], region)) best = Cut{i, at};
  }
  return best;
}

std::optional<std::pair<Cut, Cut>> find_cuts(const Drawing& drawing, const Region& region,
                                             const Loop& hole) {
  const auto length = [&](const Cut& cut) {
    return drawing.length(region.outer[cut.outer], hole[cut.hole]);
  };
  std::optional<Cut> first;
  for (std::size_t at = 0; at < hole.size(); ++at) {
    const auto cut = shortest_cut(drawing, region, hole, at, {});
    if (cut && (!first || length(*cut) < length(*first))) first = cut;
  }
  if (!first) return {};
  // Opposite corners of the hole first, then to and fro on both sides of it.
  for (std::size_t step = 0; step + 1 < hole.size(); ++step) {
    const std::size_t half = hole.size() / 2;
    const std::size_t away = step % 2 == 0 ? half + step / 2 : half - (step + 1) / 2;
    const std::size_t at = (first->hole + away) % hole.size();
    if (at == first->hole) continue;
    if (const auto second = shortest_cut(drawing, region, hole, at, first))
      return std::pair{*first, *second};
  }
  return {};
}

void append_run(Loop& target, const Loop& loop, std::size_t from, std::size_t to) {
  for (std::size_t i = from;; i = (i + 1) % loop.size()) {
    target.push_back(loop[i]);
    if (i == to) return;
  }
}

/// The part of the region along the outer loop from the cut `begin` to the cut `end`: both loops
/// have the material on their left, so the hole closes it from `end` back to `begin`.
Region part_between(const Region& region, const Loop& hole, const Cut& begin, const Cut& end) {
  Region part;
  append_run(part.outer, region.outer, begin.outer, end.outer);
  append_run(part.outer, hole, end.hole, begin.hole);
  return part;
}

}  // namespace

std::vector<Loop> cut_holes(const std::vector<glm::dvec3>& points, Loop outer,
                            std::vector<Loop> holes) {
  const Drawing drawing(points, outer);
  std::vector<Loop> pieces;
  std::vector<Region> todo;
  todo.push_back({std::move(outer), std::move(holes)});
  while (!todo.empty()) {
    Region region = std::move(todo.back());
    todo.pop_back();
    if (region.holes.empty()) {
      pieces.push_back(std::move(region.outer));
      continue;
    }
    std::optional<std::pair<Cut, Cut>> cuts;
    std::size_t chosen = 0;
    for (; chosen < region.holes.size(); ++chosen)
      if ((cuts = find_cuts(drawing, region, region.holes[chosen]))) break;
    if (!cuts) throw std::logic_error("cut_holes: no hole of the face can be cut open");

    const Loop& hole = region.holes[chosen];
    Region one = part_between(region, hole, cuts->first, cuts->second);
    Region two = part_between(region, hole, cuts->second, cuts->first);
    for (std::size_t i = 0; i < region.holes.size(); ++i) {
      if (i == chosen) continue;
      Region& owner = drawing.is_inside(region.holes[i].front(), one.outer) ? one : two;
      owner.holes.push_back(std::move(region.holes[i]));
    }
    todo.push_back(std::move(two));
    todo.push_back(std::move(one));
  }
  return pieces;
}

}  // namespace spoctree::model
