#include "client/rebuild/loop_tracer.hpp"

#include <algorithm>
#include <stdexcept>

namespace spoctree {

namespace {
constexpr auto kNowhere = static_cast<std::uint32_t>(-1);
}

double pseudo_angle(Vec2 d) {
  const double size = std::abs(d.x) + std::abs(d.y);
  if (size == 0) return 0;
  const double t = d.y / size;
  if (d.x < 0) return 2 - t;
  return d.y < 0 ? 4 + t : t;
}

void LoopTracer::trace(std::vector<PlaneEdge>& edges, const PlaneFrame& frame,
                       std::span<const Vec3> positions, TracedLoops& result) {
  std::sort(edges.begin(), edges.end());
  edges_ = edges;
  frame_ = &frame;
  positions_ = positions;
  used_.assign(edges.size(), false);
  first_.resize(edges.size());
  rays_.resize(edges.size());
  next_.assign(edges.size(), kNowhere);
  place_.assign(edges.size(), kNowhere);
  result.vertices.clear();
  result.loops.clear();
  result.branches = false;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_first = i == 0 || edges[i].from != edges[i - 1].from;
    first_[i] = is_first ? static_cast<std::uint32_t>(i) : first_[i - 1];
    result.branches |= !is_first;
  }
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (used_[start]) continue;
    std::size_t edge = start;
    path_.clear();
    for (;;) {
      // The vertex is named by its first edge.
      const std::uint32_t vertex_edge = first_[edge];
      place_[vertex_edge] = static_cast<std::uint32_t>(path_.size());
      path_.push_back(vertex_edge);
      used_[edge] = true;
      const std::uint32_t to = edges[edge].to;
      const auto found = std::lower_bound(edges.begin(), edges.end(), PlaneEdge{to, 0});
      if (found == edges.end() || found->from != to) {
        throw std::logic_error("rebuild: an edge ends at vertex " + std::to_string(to));
      }
      const auto first = static_cast<std::size_t>(found - edges.begin());
      if (place_[first] != kNowhere) {
        close_loop(place_[first], result);
        if (path_.empty()) break;
      }
      edge = next_edge(first, edges[path_.back()].from);
    }
  }
}

std::size_t LoopTracer::next_edge(std::size_t first, std::uint32_t came_from) {
  const std::uint32_t vertex = edges_[first].from;
  const auto fail = [&] {
    throw std::logic_error("rebuild: no edge leaves vertex " + std::to_string(vertex));
  };
  if (first + 1 == edges_.size() || edges_[first + 1].from != vertex) {
    if (used_[first]) fail();
    return first;
  }
  const auto end = static_cast<std::size_t>(
      std::lower_bound(edges_.begin(), edges_.end(), PlaneEdge{vertex + 1, 0}) - edges_.begin());
  const Vec2 here = frame_->project(positions_[vertex]);
  if (next_[first] == kNowhere) sort_around(first, end, here);
  // Clockwise from where we came: the region lies there.
  const double back = pseudo_angle(frame_->project(positions_[came_from]) - here);
  const auto at = [&](std::size_t i) { return rays_.cbegin() + static_cast<std::ptrdiff_t>(i); };
  const auto behind =
      std::partition_point(at(first), at(end), [&](const Ray& ray) { return ray.angle >= back; });
  std::size_t ray = next_unused(static_cast<std::size_t>(behind - rays_.cbegin()), end);
  if (ray == end) ray = next_unused(first, end);
  if (ray == end) fail();
  return rays_[ray].edge;
}

void LoopTracer::sort_around(std::size_t first, std::size_t end, Vec2 here) {
  for (std::size_t i = first; i < end; ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    rays_[i] = {pseudo_angle(frame_->project(positions_[edges_[i].to]) - here), number};
    next_[i] = number;
  }
  const auto at = [&](std::size_t i) { return rays_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::sort(at(first), at(end), [](const Ray& r, const Ray& s) {
    return r.angle != s.angle ? r.angle > s.angle : r.edge < s.edge;
  });
}

std::size_t LoopTracer::next_unused(std::size_t ray, std::size_t end) {
  std::size_t found = ray;
  while (found != end) {
    if (next_[found] == found) {
      if (!used_[rays_[found].edge]) break;
      ++next_[found];
    }
    found = next_[found];
  }
  // The next one who asks need not go all the way.
  while (ray != found) {
    const std::size_t next = next_[ray];
    next_[ray] = static_cast<std::uint32_t>(found);
    ray = next;
  }
  return found;
}

void LoopTracer::close_loop(std::size_t start, TracedLoops& result) {
  TracedLoops::Loop loop;
  loop.first = static_cast<std::uint32_t>(result.vertices.size());
  loop.count = static_cast<std::uint32_t>(path_.size() - start);
  const Vec2 origin = frame_->project(positions_[edges_[path_[start]].from]);
  Vec2 previous{0.0};
  for (std::size_t i = start; i < path_.size(); ++i) {
    const std::uint32_t vertex = edges_[path_[i]].from;
    const Vec2 here = frame_->project(positions_[vertex]) - origin;
    loop.area += 0.5 * cross(previous, here);
    previous = here;
    result.vertices.push_back(vertex);
    place_[path_[i]] = kNowhere;
  }
  path_.resize(start);
  result.loops.push_back(loop);
}

}  // namespace spoctree
