#include "server/solid/neighbours.hpp"

#include <algorithm>
#include <limits>

#include "server/solid/first_found.hpp"
#include "server/solid/touching.hpp"

namespace spoctree {

namespace {

// Half-edge 3 t + i runs from corner i of triangle t to the next. It is filed under its smaller
// vertex; `other` is the larger one.
struct FiledHalfEdge {
  std::uint32_t other;
  std::uint32_t half_edge;
  auto operator<=>(const FiledHalfEdge&) const = default;
};

std::uint32_t start_of(const GridMesh& mesh, std::uint32_t half_edge) {
  return mesh.triangles[half_edge / 3][half_edge % 3];
}
std::uint32_t end_of(const GridMesh& mesh, std::uint32_t half_edge) {
  return mesh.triangles[half_edge / 3][(half_edge % 3 + 1) % 3];
}

// One kind of faulty edge, each named by its first half-edge.
using EdgeFault = FirstFound<std::uint32_t>;

// "fault: 3 edges which, at ...", behind what is there already.
void describe(const EdgeFault& edges, const GridMesh& mesh, const std::string& fault,
              const char* edge, const char* which, std::string& text) {
  if (edges.count() == 0) return;
  if (!text.empty()) text += "; ";
  text += fault + ": " + counted(edges.count(), edge) + which + ", " +
          edges.places([&](std::uint32_t half_edge) {
            return mesh.place({start_of(mesh, half_edge), end_of(mesh, half_edge)});
          });
}

// The half-edges by edge: those of one edge stand together, in the order of the triangles.
std::vector<FiledHalfEdge> file_half_edges(const GridMesh& mesh,
                                           std::vector<std::uint32_t>& begin) {
  const auto count = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  begin.assign(mesh.vertices.size() + 1, 0);
  for (std::uint32_t h = 0; h < count; ++h) {
    ++begin[std::min(start_of(mesh, h), end_of(mesh, h)) + 1];
  }
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<FiledHalfEdge> filed(count);
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t h = 0; h < count; ++h) {
    const auto [low, high] = std::minmax({start_of(mesh, h), end_of(mesh, h)});
    filed[next[low]++] = {high, h};
  }
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    std::sort(filed.begin() + begin[v], filed.begin() + begin[v + 1]);
  }
  return filed;
}

void reject_split_vertices(const GridMesh& mesh, const std::vector<Corners>& neighbours) {
  std::vector<bool> is_seen(3 * mesh.triangles.size(), false);
  std::vector<bool> has_fan(mesh.vertices.size(), false);
  std::vector<bool> is_split(mesh.vertices.size(), false);
  FirstFound<std::uint32_t> split;
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    if (is_seen[h]) continue;
    const std::uint32_t vertex = start_of(mesh, h);
    if (has_fan[vertex] && !is_split[vertex]) {
      is_split[vertex] = true;
      split.add(vertex);
    }
    has_fan[vertex] = true;
    // Once around the vertex: across the edge that leaves it, to the one that leaves it there.
    for (std::uint32_t corner = h; !is_seen[corner];) {
      is_seen[corner] = true;
      const std::uint32_t t = neighbours[corner / 3][corner % 3];
      const Corners& corners = mesh.triangles[t];
      corner = 3 * t + (corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2);
    }
  }
  if (split.count() > 0) {
    mesh.fail_as_unsound("not a manifold: closed parts touch, or a part itself: the faces around " +
                         (split.count() == 1 ? std::string("1 vertex form")
                                             : std::to_string(split.count()) + " vertices form") +
                         " more than one fan, " +
                         split.places([&](std::uint32_t vertex) { return mesh.place({vertex}); }));
  }
}

// Whether every edge is run along as often one way as the other.
bool is_balanced(const GridMesh& mesh, const std::vector<FiledHalfEdge>& filed,
                 const std::vector<std::uint32_t>& begin) {
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    for (std::uint32_t i = begin[v]; i < begin[v + 1];) {
      const std::uint32_t other = filed[i].other;
      int balance = 0;
      for (; i < begin[v + 1] && filed[i].other == other; ++i) {
        balance += start_of(mesh, filed[i].half_edge) == v ? 1 : -1;
      }
      if (balance != 0) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Corners> find_neighbours(const GridMesh& mesh, bool may_touch_itself) {
  std::vector<std::uint32_t> begin;
  const std::vector<FiledHalfEdge> filed = file_half_edges(mesh, begin);
  std::vector<Corners> neighbours(mesh.triangles.size());
  EdgeFault crowded;
  EdgeFault border;
  EdgeFault misoriented;
  const auto join = [&](std::uint32_t h, std::uint32_t g) {
    neighbours[h / 3][h % 3] = g / 3;
    neighbours[g / 3][g % 3] = h / 3;
  };
  const auto join_wedges = [&](std::uint32_t first, std::uint32_t end) {
    std::vector<std::uint32_t> half_edges;
    for (std::uint32_t i = first; i < end; ++i) half_edges.push_back(filed[i].half_edge);
    const auto wedges = pair_around_edge(mesh, half_edges);
    if (!wedges) return false;
    for (const auto& [h, g] : *wedges) join(h, g);
    return true;
  };
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    for (std::uint32_t i = begin[v]; i < begin[v + 1];) {
      std::uint32_t end = i + 1;
      while (end < begin[v + 1] && filed[end].other == filed[i].other) ++end;
      const std::uint32_t h = filed[i].half_edge;
      if (end - i > 2) {
        if (!may_touch_itself || !join_wedges(i, end)) crowded.add(h);
      } else if (end - i == 1) {
        border.add(h);
      } else {
        const std::uint32_t g = filed[i + 1].half_edge;
        if (start_of(mesh, g) == start_of(mesh, h)) misoriented.add(h);
        join(h, g);
      }
      i = end;
    }
  }
  std::string faults;
  describe(crowded, mesh,
           crowded.count() > 0 && is_balanced(mesh, filed, begin)
               ? "not a manifold: closed parts touch, or a part itself"
               : "not a manifold",
           "edge", " with more than two faces", faults);
  describe(border, mesh, "not closed", "border edge", "", faults);
  describe(misoriented, mesh, "not consistently oriented", "edge", " whose two faces disagree",
           faults);
  if (!faults.empty()) mesh.fail_as_unsound(faults);
  if (!may_touch_itself) reject_split_vertices(mesh, neighbours);
  return neighbours;
}

}  // namespace spoctree
