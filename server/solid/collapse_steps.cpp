#include "server/solid/collapse_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>
#include <utility>

#include "server/solid/box_tree.hpp"
#include "server/solid/point_clusters.hpp"

namespace spoctree {

namespace {

constexpr int kMostRounds = 8;

// Where points are heaped up more than this, nothing is made one.
constexpr std::size_t kMostPairsPerPoint = 256;

// Loops longer than this are halved anywhere before the shortest diagonals are looked for.
constexpr std::size_t kLongLoop = 48;

using Edge = std::array<std::uint32_t, 2>;  // the smaller number first

Edge edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// A corner of a polygon and the sides of the triangle, a bit each, that it is on. Corners that
// share a bit are on one line.
struct LoopCorner {
  std::uint32_t point;
  unsigned sides;
};
using Loop = std::vector<LoopCorner>;

class Collapse {
 public:
  Collapse(std::span<const Vec3> points, std::span<const StepPoint> kinds, double distance,
           std::vector<Corners>& triangles, std::vector<std::uint32_t>& source)
      : points_(points),
        kinds_(kinds),
        distance_(distance),
        triangles_(triangles),
        source_(source) {}

  bool run() {
    bool is_changed = merge_points();
    for (int round = 0; round < kMostRounds && divide_edges(); ++round) is_changed = true;
    if (is_changed) cancel_opposites();
    return is_changed;
  }

 private:
  std::vector<std::uint32_t> used_points() const {
    std::vector<std::uint32_t> used;
    used.reserve(3 * triangles_.size());
    for (const Corners& t : triangles_) used.insert(used.end(), t.begin(), t.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    return used;
  }

  bool is_fixed(std::uint32_t v) const { return kinds_[v] == StepPoint::Fixed; }

  bool merge_points() {
    const std::vector<std::uint32_t> used = used_points();
    std::vector<Vec3> places;
    for (const std::uint32_t v : used) places.push_back(points_[v]);
    std::vector<PointPair> near;
    const bool are_all = visit_near_points(places, distance_, kMostPairsPerPoint * places.size(),
                                           [&](std::uint32_t i, std::uint32_t j) {
                                             if (is_fixed(used[i]) && is_fixed(used[j])) return;
                                             if (glm::length(places[i] - places[j]) < distance_)
                                               near.push_back({i, j});
                                           });
    if (!are_all || near.empty()) return false;
    std::vector<Box> boxes;
    for (const Vec3& p : places) boxes.push_back({p, p});
    const auto cluster = bounded_clusters(std::move(boxes), near, kWidestStep * distance_);
    const auto chosen = choose_points(cluster, [&](std::uint32_t i) {
      const Vec3 p = places[i];
      return PointRank{static_cast<std::uint32_t>(kinds_[used[i]]), {p.z, p.y, p.x}};
    });
    std::vector<std::uint32_t> becomes(points_.size());
    std::iota(becomes.begin(), becomes.end(), 0u);
    for (std::uint32_t i = 0; i < used.size(); ++i) becomes[used[i]] = used[chosen[i]];
    std::vector<Corners> triangles = std::move(triangles_);
    const std::vector<std::uint32_t> source = std::move(source_);
    triangles_.clear();
    source_.clear();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      Corners& c = triangles[t];
      for (std::uint32_t& v : c) v = becomes[v];
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
      triangles_.push_back(c);
      source_.push_back(source[t]);
    }
    return true;
  }

  // Whether any edge has got points.
  bool divide_edges() {
    std::vector<Edge> edges;
    for (const Corners& t : triangles_) {
      for (std::size_t i = 0; i < 3; ++i) edges.push_back(edge_of(t[i], t[(i + 1) % 3]));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const std::vector<std::uint32_t> used = used_points();
    std::vector<Box> boxes;
    for (const std::uint32_t v : used) boxes.push_back({points_[v], points_[v]});
    const BoxTree tree(boxes);
    std::vector<std::vector<std::uint32_t>> between(edges.size());
    bool is_any = false;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      between[e] = points_near(edges[e], used, tree);
      is_any = is_any || !between[e].empty();
    }
    if (!is_any) return false;
    std::vector<Corners> triangles = std::move(triangles_);
    const std::vector<std::uint32_t> source = std::move(source_);
    triangles_.clear();
    source_.clear();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Corners& c = triangles[t];
      Loop loop;
      for (unsigned i = 0; i < 3; ++i) {
        loop.push_back({c[i], (1u << i) | (1u << ((i + 2) % 3))});
        const Edge edge = edge_of(c[i], c[(i + 1) % 3]);
        const auto place = std::lower_bound(edges.begin(), edges.end(), edge) - edges.begin();
        const auto& points = between[static_cast<std::size_t>(place)];
        const std::size_t begin = loop.size();
        for (const std::uint32_t v : points) loop.push_back({v, 1u << i});
        if (edge[0] != c[i]) {
          std::reverse(loop.begin() + static_cast<std::ptrdiff_t>(begin), loop.end());
        }
      }
      fill(loop, source[t]);
    }
    return true;
  }

  // In order from the edge's first end to its second.
  std::vector<std::uint32_t> points_near(const Edge& edge, std::span<const std::uint32_t> used,
                                         const BoxTree& tree) const {
    const Vec3 from = points_[edge[0]];
    const Vec3 way = points_[edge[1]] - from;
    const double square = glm::dot(way, way);
    const auto distance_from = [&](Vec3 p, double& along) {
      along = square > 0 ? glm::dot(p - from, way) / square : 0;
      return glm::length(p - from - std::clamp(along, 0.0, 1.0) * way);
    };
    const bool is_end_loose = !is_fixed(edge[0]) || !is_fixed(edge[1]);
    std::vector<std::pair<double, std::uint32_t>> found;
    tree.visit_if(
        [&](const Box& box) {
          double along = 0;
          const Vec3 half = 0.5 * (box.upper - box.lower);
          return distance_from(box.lower + half, along) <= 2 * distance_ + glm::length(half);
        },
        [&](std::uint32_t i) {
          const std::uint32_t v = used[i];
          if (v == edge[0] || v == edge[1] || (is_fixed(v) && !is_end_loose)) return true;
          double along = 0;
          if (distance_from(points_[v], along) < distance_ && along > 0 && along < 1) {
            found.emplace_back(along, v);
          }
          return true;
        });
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> points;
    for (const auto& [along, v] : found) points.push_back(v);
    return points;
  }

  // Triangles of what the loop runs around; an edge there and back is none.
  void fill(Loop loop, std::uint32_t source) {
    // A point that is on several sides is a corner between them.
    for (LoopCorner& a : loop) {
      for (const LoopCorner& b : loop) {
        if (a.point == b.point) a.sides |= b.sides;
      }
    }
    Loop walk;
    const auto cut = [&](std::size_t begin) {
      if (walk.size() - begin >= 3) {
        fill_simple({walk.begin() + static_cast<std::ptrdiff_t>(begin), walk.end()}, source);
      }
      walk.resize(begin);
    };
    for (const LoopCorner& corner : loop) {
      for (std::size_t i = 0; i < walk.size(); ++i) {
        if (walk[i].point == corner.point) cut(i);
      }
      walk.push_back(corner);
    }
    cut(0);
  }

  // Diagonals join corners that are not on one side, so that no triangle is a line.
  void fill_simple(Loop loop, std::uint32_t source) {
    std::vector<Loop> loops{std::move(loop)};
    while (!loops.empty()) {
      Loop now = std::move(loops.back());
      loops.pop_back();
      if (now.size() == 3) {
        triangles_.push_back({now[0].point, now[1].point, now[2].point});
        source_.push_back(source);
        continue;
      }
      const auto [i, j] = find_diagonal(now);
      const auto begin = now.begin();
      const auto at = [&](std::size_t k) { return begin + static_cast<std::ptrdiff_t>(k); };
      Loop first(at(i), at(j) + 1);
      Loop second(at(j), now.end());
      second.insert(second.end(), begin, at(i) + 1);
      loops.push_back(std::move(first));
      loops.push_back(std::move(second));
    }
  }

  std::pair<std::size_t, std::size_t> find_diagonal(const Loop& loop) const {
    const std::size_t n = loop.size();
    const auto is_possible = [&](std::size_t i, std::size_t j) {
      return (loop[i].sides & loop[j].sides) == 0;
    };
    if (n > kLongLoop) {
      for (std::size_t apart = n / 2; apart >= 2; --apart) {
        for (std::size_t i = 0; i + apart < n; ++i) {
          if (is_possible(i, i + apart)) return {i, i + apart};
        }
      }
    }
    std::pair<std::size_t, std::size_t> best{0, 2};
    double least = -1;
    for (std::size_t i = 0; i + 2 < n; ++i) {
      for (std::size_t j = i + 2; j < n && j - i + 1 < n; ++j) {
        if (!is_possible(i, j)) continue;
        const double length = glm::length(points_[loop[i].point] - points_[loop[j].point]);
        if (least >= 0 && length >= least) continue;
        least = length;
        best = {i, j};
      }
    }
    return best;
  }

  // Of triangles over the same corners as many are left as there are more one way than the other.
  void cancel_opposites() {
    struct Key {
      Corners sorted;
      bool is_odd;
      std::uint32_t triangle;
    };
    std::vector<Key> keys;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      Corners c = triangles_[t];
      std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
      const bool is_odd = c[1] > c[2];
      if (is_odd) std::swap(c[1], c[2]);
      keys.push_back({c, is_odd, t});
    }
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
      return std::tie(a.sorted, a.is_odd, a.triangle) < std::tie(b.sorted, b.is_odd, b.triangle);
    });
    std::vector<std::uint8_t> is_kept(triangles_.size(), 0);
    for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
      while (end < keys.size() && keys[end].sorted == keys[begin].sorted) ++end;
      const auto odd =
          static_cast<std::size_t>(std::count_if(keys.begin() + static_cast<std::ptrdiff_t>(begin),
                                                 keys.begin() + static_cast<std::ptrdiff_t>(end),
                                                 [](const Key& key) { return key.is_odd; }));
      const std::size_t even = end - begin - odd;
      // The even ones come first.
      for (std::size_t k = odd; k < even; ++k) is_kept[keys[begin + k].triangle] = 1;
      for (std::size_t k = even; k < odd; ++k) is_kept[keys[begin + even + k].triangle] = 1;
    }
    std::size_t end = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (is_kept[t] == 0) continue;
      triangles_[end] = triangles_[t];
      source_[end++] = source_[t];
    }
    triangles_.resize(end);
    source_.resize(end);
  }

  std::span<const Vec3> points_;
  std::span<const StepPoint> kinds_;
  double distance_;
  std::vector<Corners>& triangles_;
  std::vector<std::uint32_t>& source_;
};

}  // namespace

bool collapse_steps(std::span<const Vec3> points, std::span<const StepPoint> kinds, double distance,
                    std::vector<Corners>& triangles, std::vector<std::uint32_t>& source) {
  return Collapse(points, kinds, distance, triangles, source).run();
}

}  // namespace spoctree
