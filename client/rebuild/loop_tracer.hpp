// Directed edges in a plane -> simple loops.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/rebuild/plane_frame.hpp"

namespace spoctree {

/// An edge of a region that lies to its left.
struct PlaneEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  auto operator<=>(const PlaneEdge&) const = default;
};

/// Loops as ranges of one array of vertices; `area` is positive if counter-clockwise.
struct TracedLoops {
  struct Loop {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    double area = 0;
  };
  std::vector<std::uint32_t> vertices;
  std::vector<Loop> loops;
  bool branches = false;  ///< some vertex has more than one edge leaving it

  std::span<const std::uint32_t> vertices_of(const Loop& loop) const {
    return {vertices.data() + loop.first, loop.count};
  }
};

/// Holds working memory.
class LoopTracer {
 public:
  /// Uses every edge once. In a vertex with several edges the sharpest turn to the left is taken,
  /// and a loop ends when it meets itself, so that no loop has a vertex twice; the same edges give
  /// the same loops. REQUIRES: as many edges leave every vertex as arrive; no edge and its
  /// opposite. O(n log n), however many edges leave a vertex. Throws std::logic_error if the edges
  /// are no such cycles.
  void trace(std::vector<PlaneEdge>& edges, const PlaneFrame& frame,
             std::span<const Vec3> positions, TracedLoops& result);

 private:
  std::size_t next_edge(std::size_t first, std::uint32_t came_from);
  void sort_around(std::size_t first, std::size_t end, Vec2 here);
  std::size_t next_unused(std::size_t ray, std::size_t end);
  void close_loop(std::size_t start, TracedLoops& result);

  std::span<const PlaneEdge> edges_;
  const PlaneFrame* frame_ = nullptr;
  std::span<const Vec3> positions_;
  std::vector<bool> used_;
  std::vector<std::uint32_t> first_;  // of the edges that leave the same vertex, by edge
  // Where it is asked for, the edges that leave a vertex, clockwise, in the place of its edges.
  struct Ray {
    double angle = 0;
    std::uint32_t edge = 0;
  };
  std::vector<Ray> rays_;
  // By ray: itself or a later one, none between them being unused. Not a number until its vertex's
  // edges are sorted.
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> place_;  // on path_, by the vertex's first leaving edge
  std::vector<std::uint32_t> path_;   // first leaving edge of each vertex
};

/// A function of the direction that increases with its angle, from 0 to below 4.
double pseudo_angle(Vec2 direction);

}  // namespace spoctree
