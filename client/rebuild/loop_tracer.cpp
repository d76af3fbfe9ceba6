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
  place_.assign(edges.size(), kNowhere);
  result.vertices.clear();
  result.loops.clear();
  result.branches = false;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    result.branches |= edges[i].from == edges[i - 1].from;
  }
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (used_[start]) continue;
    std::size_t edge = start;
    path_.clear();
    for (;;) {
      // The vertex is named by its first edge.
      auto vertex_edge = edge;
      while (vertex_edge > 0 && edges[vertex_edge - 1].from == edges[edge].from) --vertex_edge;
      place_[vertex_edge] = static_cast<std::uint32_t>(path_.size());
      path_.push_back(static_cast<std::uint32_t>(vertex_edge));
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
  std::size_t best = edges_.size();
  double best_turn = 5;
  double back = -1;
  for (std::size_t i = first; i < edges_.size() && edges_[i].from == vertex; ++i) {
    if (used_[i]) continue;
    if (best == edges_.size()) {
      best = i;
      continue;
    }
    const auto turn_to = [&](std::size_t edge) {
      const Vec2 here = frame_->project(positions_[vertex]);
      if (back < 0) back = pseudo_angle(frame_->project(positions_[came_from]) - here);
      // Clockwise from where we came: the region lies there.
      const double turn = back - pseudo_angle(frame_->project(positions_[edges_[edge].to]) - here);
      return turn > 0 ? turn : turn + 4;
    };
    if (best_turn > 4) best_turn = turn_to(best);
    const double turn = turn_to(i);
    if (turn < best_turn) {
      best_turn = turn;
      best = i;
    }
  }
  if (best == edges_.size()) {
    throw std::logic_error("rebuild: no edge leaves vertex " + std::to_string(vertex));
  }
  return best;
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
