#include "client/rebuild/settle_vertices.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <utility>

#include "common/base/parallel.hpp"
#include "common/geometry/predicates.hpp"
#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

/// Below this determinant of their normals, three planes do not fix a point well enough.
constexpr double kLeastIndependence = 1e-9;

/// The carriers around every vertex.
class CarriersAround {
 public:
  CarriersAround(const Chain& chain, std::size_t vertex_count) : begin_(vertex_count + 1) {
    for (const ChainEdge& use : chain) {
      ++begin_[use.a + 1];
      ++begin_[use.b + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    around_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (const ChainEdge& use : chain) {
      around_[next[use.a]++] = use.carrier;
      around_[next[use.b]++] = use.carrier;
    }
  }
  /// With repetitions.
  std::span<const std::uint32_t> of(std::uint32_t vertex) const {
    return {around_.data() + begin_[vertex], begin_[vertex + 1] - begin_[vertex]};
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> around_;
};

/// Where the three most independent of the planes meet (found greedily).
std::optional<Vec3> meeting_point(std::span<const std::uint32_t> planes, const Carriers& carriers) {
  const std::uint32_t p = planes.front();
  std::uint32_t q = p;
  std::uint32_t r = p;
  Vec3 pq{0.0};
  for (const std::uint32_t plane : planes) {
    const Vec3 c = glm::cross(carriers.plane(p).normal, carriers.plane(plane).normal);
    if (glm::dot(c, c) > glm::dot(pq, pq)) {
      pq = c;
      q = plane;
    }
  }
  double best = 0;
  for (const std::uint32_t plane : planes) {
    const double determinant = std::abs(glm::dot(pq, carriers.plane(plane).normal));
    if (determinant > best) {
      best = determinant;
      r = plane;
    }
  }
  if (best < kLeastIndependence) return std::nullopt;
  return intersection_point(carriers.plane(p), carriers.plane(q), carriers.plane(r)).position;
}

bool all_pass(std::span<const std::uint32_t> planes, const Carriers& carriers, Vec3 point,
              double tolerance) {
  return std::all_of(planes.begin(), planes.end(), [&](std::uint32_t i) {
    const Plane& plane = carriers.plane(i);
    return std::abs(glm::dot(plane.normal, point) - plane.offset) <= tolerance;
  });
}

struct ShortEdge {
  double length;
  std::uint32_t a, b;
  auto operator<=>(const ShortEdge&) const = default;
};

std::vector<ShortEdge> find_short_edges(const Chain& chain, std::span<const Vec3> positions,
                                        double limit) {
  std::vector<ShortEdge> edges;
  for_each_edge(chain, [&](std::size_t i, std::size_t) {
    const double length = glm::distance(positions[chain[i].a], positions[chain[i].b]);
    if (length < limit) edges.push_back({length, chain[i].a, chain[i].b});
  });
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Sets of vertices that became one, with the planes around them.
class VertexMerger {
 public:
  VertexMerger(const CarriersAround& around, const Carriers& carriers, std::vector<Vec3> points)
      : around_(around), carriers_(carriers), points_(std::move(points)), set_of_(points_.size()) {
    std::iota(set_of_.begin(), set_of_.end(), 0u);
  }

  std::uint32_t find(std::uint32_t vertex) {
    while (set_of_[vertex] != vertex) vertex = set_of_[vertex] = set_of_[set_of_[vertex]];
    return vertex;
  }

  void try_merge(std::uint32_t a, std::uint32_t b, double tolerance) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    std::vector<std::uint32_t> both = planes_of(a);
    const std::vector<std::uint32_t> more = planes_of(b);
    both.insert(both.end(), more.begin(), more.end());
    std::sort(both.begin(), both.end());
    both.erase(std::unique(both.begin(), both.end()), both.end());
    const std::optional<Vec3> point = common_point(both, {points_[a], points_[b]}, tolerance);
    if (!point) return;
    const std::uint32_t kept = std::min(a, b);
    set_of_[std::max(a, b)] = kept;
    points_[kept] = *point;
    merged_.push_back({kept, std::move(both)});
  }

  bool is_empty() const { return merged_.empty(); }
  /// Calls visit(vertex, position) for the vertices that stand for others.
  template <class Visit>
  void for_each_kept(Visit&& visit) const {
    for (const Merged& merged : merged_) visit(merged.vertex, points_[merged.vertex]);
  }

 private:
  struct Merged {
    std::uint32_t vertex;
    std::vector<std::uint32_t> planes;
  };

  /// A point on all planes: where they meet, or if they are too parallel for that, a known one.
  std::optional<Vec3> common_point(std::span<const std::uint32_t> planes,
                                   std::initializer_list<Vec3> known, double tolerance) const {
    const std::optional<Vec3> meeting = meeting_point(planes, carriers_);
    if (meeting && all_pass(planes, carriers_, *meeting, tolerance)) return meeting;
    for (const Vec3 point : known) {
      if (all_pass(planes, carriers_, point, tolerance)) return point;
    }
    return std::nullopt;
  }

  std::vector<std::uint32_t> planes_of(std::uint32_t vertex) const {
    // The latest entry is the whole; clusters are few and small.
    const auto last = std::find_if(merged_.rbegin(), merged_.rend(),
                                   [&](const Merged& m) { return m.vertex == vertex; });
    if (last != merged_.rend()) return last->planes;
    const auto planes = around_.of(vertex);
    return {planes.begin(), planes.end()};
  }

  const CarriersAround& around_;
  const Carriers& carriers_;
  std::vector<Vec3> points_;
  std::vector<std::uint32_t> set_of_;
  std::vector<Merged> merged_;
};

bool merge_clusters(Chain& chain, const Carriers& carriers, VertexWelder& welder) {
  // The welder's tolerance is kWeldTolerance of the diagonal.
  const double diagonal = welder.tolerance() / kWeldTolerance;
  const auto& positions = welder.vertices();
  const std::vector<ShortEdge> edges = find_short_edges(chain, positions, kShortEdge * diagonal);
  if (edges.empty()) return false;
  const CarriersAround around(chain, positions.size());
  VertexMerger merger(around, carriers, positions);
  for (const ShortEdge& edge : edges) {
    merger.try_merge(edge.a, edge.b, kMeetingTolerance * diagonal);
  }
  if (merger.is_empty()) return false;
  Chain unchanged;
  unchanged.reserve(chain.size());
  Chain mapped;
  for (const ChainEdge& use : chain) {
    const std::uint32_t a = merger.find(use.a);
    const std::uint32_t b = merger.find(use.b);
    if (a == use.a && b == use.b) {
      unchanged.push_back(use);
    } else if (a != b) {
      mapped.push_back(directed_edge(a, b, use.carrier, use.count));
    }
  }
  chain.swap(unchanged);
  add_to_chain(chain, std::move(mapped), positions.size());
  merger.for_each_kept([&](std::uint32_t vertex, Vec3 point) { welder.move(vertex, point); });
  return true;
}

}  // namespace

bool settle_vertices(Chain& chain, const Carriers& carriers, VertexWelder& welder) {
  const bool merged = merge_clusters(chain, carriers, welder);
  const double diagonal = welder.tolerance() / kWeldTolerance;
  const auto vertex_count = static_cast<std::uint32_t>(welder.vertices().size());
  const CarriersAround around(chain, vertex_count);
  std::vector<std::optional<Vec3>> points(vertex_count);
  parallel_for(vertex_count, [&](std::size_t vertex) {
    const auto planes = around.of(static_cast<std::uint32_t>(vertex));
    if (!planes.empty()) points[vertex] = meeting_point(planes, carriers);
  });
  for (std::uint32_t vertex = 0; vertex < vertex_count; ++vertex) {
    const std::optional<Vec3>& point = points[vertex];
    // Not far: a vertex that was put on a bent edge does not lie on all its planes.
    if (point && glm::distance(*point, welder.vertices()[vertex]) < kShortEdge * diagonal) {
      welder.move(vertex, *point);
    }
  }
  return merged;
}

}  // namespace spoctree
