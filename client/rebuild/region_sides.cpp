#include "client/rebuild/region_sides.hpp"

#include <algorithm>
#include <numeric>

namespace spoctree {

namespace {

/// Half-edge 2 i runs along edge i, 2 i + 1 against it. `left` is the value to its left.
class PlaneValues {
 public:
  PlaneValues(std::span<const CountedEdge> edges, const PlaneFrame& frame,
              std::span<const Vec3> positions)
      : edges_(edges), frame_(frame), positions_(positions) {
    sort_around_vertices();
    left_.assign(half_edges(), 0);
    part_.assign(half_edges(), kNoPart);
    std::uint32_t parts = 0;
    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      if (part_[h] == kNoPart) spread(h, parts++);
    }
    const std::vector<std::uint32_t> extremes = find_extremes(parts);
    // Around the vertex with the smallest x, the widest sector faces -x.
    std::vector<std::int32_t> base = find_values_outside(extremes);
    for (std::uint32_t part = 0; part < parts; ++part) base[part] -= left_[extremes[part]];
    for (std::uint32_t h = 0; h < half_edges(); ++h) left_[h] += base[part_[h]];
  }

  std::int32_t left(std::uint32_t half_edge) const { return left_[half_edge]; }

  /// False if a value changes by something else than an edge's count across it, or within a sector
  /// between two edges that are next to each other around a vertex: the edges cross.
  bool are_consistent() const {
    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      const std::uint32_t next = next_[h];
      if (left_[h] - left_[h ^ 1u] != count(h) || left_[next ^ 1u] != left_[h]) return false;
    }
    return true;
  }

 private:
  static constexpr auto kNoPart = static_cast<std::uint32_t>(-1);

  std::uint32_t half_edges() const { return static_cast<std::uint32_t>(2 * edges_.size()); }
  std::uint32_t origin(std::uint32_t h) const {
    const PlaneEdge& edge = edges_[h / 2].edge;
    return h % 2 == 0 ? edge.from : edge.to;
  }
  std::int32_t count(std::uint32_t h) const {
    return h % 2 == 0 ? edges_[h / 2].count : -edges_[h / 2].count;
  }
  Vec2 point(std::uint32_t h) const { return frame_.project(positions_[origin(h)]); }

  void sort_around_vertices() {
    struct Ray {
      std::uint32_t origin;
      double angle;
      std::uint32_t half_edge;
      auto operator<=>(const Ray&) const = default;
    };
    std::vector<Ray> rays;
    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      // Angles from -x on, so that the first and the last ray enclose the direction -x.
      rays.push_back({origin(h), pseudo_angle(point(h) - point(h ^ 1u)), h});
    }
    std::sort(rays.begin(), rays.end());
    next_.resize(rays.size());
    previous_.resize(rays.size());
    is_last_.assign(rays.size(), false);
    for (std::size_t begin = 0, end = 0; begin < rays.size(); begin = end) {
      while (end < rays.size() && rays[end].origin == rays[begin].origin) ++end;
      for (std::size_t i = begin; i < end; ++i) {
        const std::size_t j = i + 1 == end ? begin : i + 1;
        next_[rays[i].half_edge] = rays[j].half_edge;
        previous_[rays[j].half_edge] = rays[i].half_edge;
      }
      is_last_[rays[end - 1].half_edge] = true;
    }
  }

  /// Numbers a connected part and finds its values relative to the first half-edge's.
  void spread(std::uint32_t start, std::uint32_t part) {
    std::vector<std::uint32_t> open{start};
    part_[start] = part;
    const auto reach = [&](std::uint32_t h, std::int32_t value) {
      if (part_[h] != kNoPart) return;
      part_[h] = part;
      left_[h] = value;
      open.push_back(h);
    };
    while (!open.empty()) {
      const std::uint32_t h = open.back();
      open.pop_back();
      const std::int32_t right = left_[h] - count(h);
      reach(h ^ 1u, right);
      reach(previous_[h], right);
      reach(next_[h], left_[h] + count(next_[h]));
    }
  }

  /// Per part, the last half-edge around its vertex of smallest x: to its left is the outside.
  std::vector<std::uint32_t> find_extremes(std::uint32_t parts) const {
    std::vector<std::uint32_t> extremes(parts, kNoPart);
    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      if (!is_last_[h]) continue;
      std::uint32_t& best = extremes[part_[h]];
      const auto less = [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
      if (best == kNoPart || less(point(h), point(best))) best = h;
    }
    return extremes;
  }

  /// The values around all parts: what the other parts enclose, along rays from -x to the extremes.
  /// A sweep over y: on a cell wall there may be thousands of parts.
  std::vector<std::int32_t> find_values_outside(std::span<const std::uint32_t> extremes) const {
    std::vector<std::int32_t> values(extremes.size(), 0);
    if (extremes.size() == 1) return values;
    struct Span {
      double lower, upper;  // y, without `upper`
      std::uint32_t half_edge;
    };
    std::vector<Span> spans;
    for (std::uint32_t h = 0; h < half_edges(); h += 2) {
      const double y = point(h).y;
      const double z = point(h ^ 1u).y;
      if (y != z) spans.push_back({std::min(y, z), std::max(y, z), h});
    }
    std::sort(spans.begin(), spans.end(),
              [](const Span& s, const Span& t) { return s.lower < t.lower; });
    std::vector<std::uint32_t> order(extremes.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto y_of = [&](std::uint32_t part) { return point(extremes[part]).y; };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t s, std::uint32_t t) { return y_of(s) < y_of(t); });
    std::vector<Span> open;
    auto next = spans.begin();
    for (const std::uint32_t part : order) {
      const Vec2 p = point(extremes[part]);
      for (; next != spans.end() && next->lower <= p.y; ++next) open.push_back(*next);
      std::size_t kept = 0;
      for (const Span& span : open) {
        if (span.upper <= p.y) continue;
        open[kept++] = span;
        const std::uint32_t h = span.half_edge;
        if (part_[h] == part) continue;
        const Vec2 a = point(h);
        const Vec2 b = point(h ^ 1u);
        const bool is_right_of_edge = (cross(b - a, p - a) < 0) == (b.y > a.y);
        if (is_right_of_edge) values[part] += b.y > a.y ? -count(h) : count(h);
      }
      open.resize(kept);
    }
    return values;
  }

  std::span<const CountedEdge> edges_;
  const PlaneFrame& frame_;
  std::span<const Vec3> positions_;
  std::vector<std::uint32_t> next_, previous_;  // around the origin, counter-clockwise
  std::vector<bool> is_last_;
  std::vector<std::int32_t> left_;
  std::vector<std::uint32_t> part_;
};

}  // namespace

void separate_sides(std::span<const CountedEdge> edges, const PlaneFrame& frame,
                    std::span<const Vec3> positions, std::vector<PlaneEdge>& front,
                    std::vector<PlaneEdge>& back) {
  front.clear();
  back.clear();
  const PlaneValues values(edges, frame, positions);
  const auto add = [](std::vector<PlaneEdge>& list, PlaneEdge edge, std::int32_t times) {
    for (std::int32_t i = 0; i < times; ++i) list.push_back(edge);
  };
  if (!values.are_consistent()) {
    for (const CountedEdge& edge : edges) add(front, edge.edge, edge.count);
    return;
  }
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const std::int32_t left = values.left(2 * i);
    const std::int32_t right = values.left(2 * i + 1);
    add(front, edges[i].edge, std::max(left, 0) - std::max(right, 0));
    add(back, edges[i].edge, std::max(-right, 0) - std::max(-left, 0));
  }
}

}  // namespace spoctree
