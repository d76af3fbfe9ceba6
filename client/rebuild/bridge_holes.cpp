#include "client/rebuild/bridge_holes.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace spoctree {

namespace {

/// An edge or bridge that stands in the way.
struct Obstacle {
  std::uint32_t a, b;
};

class Bridger {
 public:
  Bridger(std::span<const std::span<const std::uint32_t>> loops, const PlaneFrame& frame,
          std::span<const Vec3> positions)
      : frame_(frame), positions_(positions) {
    for (const auto loop : loops) {
      std::uint32_t from = loop.back();
      for (const std::uint32_t to : loop) {
        edges_.push_back({from, to});
        obstacles_.push_back({from, to});
        from = to;
      }
      vertices_.insert(vertices_.end(), loop.begin(), loop.end());
    }
    std::sort(vertices_.begin(), vertices_.end());
  }

  void bridge(std::span<const std::uint32_t> hole) {
    for (const double direction : {1.0, -1.0}) {
      const auto less = [&](std::uint32_t u, std::uint32_t v) {
        return point(u, direction).x < point(v, direction).x;
      };
      const std::uint32_t start = *std::min_element(hole.begin(), hole.end(), less);
      if (is_shared(start)) continue;  // another loop touches here, so the way left is open
      const std::uint32_t end = find_left(start, direction);
      if (end == start) continue;
      const auto is_there = [&](const Obstacle& o) {
        return (o.a == start && o.b == end) || (o.a == end && o.b == start);
      };
      if (std::any_of(obstacles_.begin(), obstacles_.end(), is_there)) continue;
      obstacles_.push_back({start, end});
      edges_.push_back({start, end});
      edges_.push_back({end, start});
    }
  }

  std::vector<PlaneEdge>& edges() { return edges_; }

 private:
  /// The point in oblique coordinates; direction -1 turns them by half a turn.
  Vec2 point(std::uint32_t vertex, double direction) const {
    const Vec2 p = frame_.project(positions_[vertex]);
    constexpr double kCosine = 0.81649658092772603;  // an angle of 35.26 degrees
    constexpr double kSine = 0.57735026918962576;
    return direction * Vec2{kCosine * p.x - kSine * p.y, kSine * p.x + kCosine * p.y};
  }

  bool is_shared(std::uint32_t vertex) const {
    const auto [first, last] = std::equal_range(vertices_.begin(), vertices_.end(), vertex);
    return last - first > 1;
  }

  /// A vertex left of `start` that sees it; `start` itself if there is none (rounding).
  std::uint32_t find_left(std::uint32_t start, double direction) const {
    const Vec2 s = point(start, direction);
    double hit_x = -std::numeric_limits<double>::infinity();
    std::uint32_t best = start;
    for (const Obstacle& obstacle : obstacles_) {
      if (obstacle.a == start || obstacle.b == start) continue;
      const Vec2 a = point(obstacle.a, direction);
      const Vec2 b = point(obstacle.b, direction);
      if ((a.y <= s.y) == (b.y <= s.y)) continue;
      const double x = a.x + (b.x - a.x) * ((s.y - a.y) / (b.y - a.y));
      if (x < s.x && x > hit_x) {
        hit_x = x;
        best = a.x < b.x ? obstacle.a : obstacle.b;
      }
    }
    if (best == start) return start;
    // What is seen first when the ray turns from the hit towards that end of the edge: of the
    // vertices in this triangle the one nearest to the ray's direction.
    const Vec2 hit{hit_x, s.y};
    const Vec2 end = point(best, direction);
    const double side = end.y < s.y ? -1 : 1;
    Vec2 best_offset = end - s;
    for (const std::uint32_t vertex : vertices_) {
      const Vec2 p = point(vertex, direction);
      if (vertex == start || vertex == best || p.x >= s.x || (p.y - s.y) * side < 0) continue;
      // On the near side of the edge that was hit.
      if (cross(end - hit, p - hit) * side > 0) continue;
      const Vec2 offset = p - s;
      const double turn = cross(offset, best_offset) * -side;
      // In line, up to rounding: the nearer one hides the other.
      const double doubt = 1e-13 * glm::length(offset) * glm::length(best_offset);
      if (turn > doubt ||
          (turn > -doubt && glm::dot(offset, offset) < glm::dot(best_offset, best_offset))) {
        best_offset = offset;
        best = vertex;
      }
    }
    return best;
  }

  const PlaneFrame& frame_;
  std::span<const Vec3> positions_;
  std::vector<PlaneEdge> edges_;
  std::vector<Obstacle> obstacles_;
  std::vector<std::uint32_t> vertices_;
};

}  // namespace

void bridge_holes(std::span<const std::span<const std::uint32_t>> loops, const PlaneFrame& frame,
                  std::span<const Vec3> positions, TracedLoops& result) {
  Bridger bridger(loops, frame, positions);
  for (const auto hole : loops.subspan(1)) bridger.bridge(hole);
  LoopTracer().trace(bridger.edges(), frame, positions, result);
}

}  // namespace spoctree
