#include "server/solid/split_polygon.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <optional>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct TriangleState {
  bool is_inside = false;
  std::array<bool, 3> is_bounded{};  ///< by the polygon, across from each corner
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<TriangleState, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

/// From one corner of the polygon to another, by their places in it.
struct Edge {
  std::uint32_t from;
  std::uint32_t to;
};

// For every corner the first one with its number.
std::vector<std::uint32_t> find_first_visits(std::span<const std::uint32_t> face) {
  std::vector<std::uint32_t> first(face.size());
  for (std::uint32_t i = 0; i < face.size(); ++i) first[i] = i;
  if (!repeated_vertex(face)) return first;
  std::vector<std::uint32_t> order = first;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return face[a] != face[b] ? face[a] < face[b] : a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (face[order[i]] == face[order[i - 1]]) first[order[i]] = first[order[i - 1]];
  }
  return first;
}

// What is left of the edges when those of opposite directions have cancelled each other; nothing if
// one is left more than once.
std::optional<std::vector<Edge>> find_border(const std::vector<std::uint32_t>& corners) {
  std::vector<Edge> edges;
  edges.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Edge edge{corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]};
    if (edge.from != edge.to) edges.push_back(edge);
  }
  const auto ends = [](const Edge& e) { return std::minmax(e.from, e.to); };
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
    return ends(a) != ends(b) ? ends(a) < ends(b) : a.from < b.from;
  });
  std::vector<Edge> border;
  for (std::size_t i = 0; i < edges.size();) {
    const auto [low, high] = ends(edges[i]);
    int upwards = 0;
    for (; i < edges.size() && ends(edges[i]) == std::minmax(low, high); ++i) {
      upwards += edges[i].from == low ? 1 : -1;
    }
    if (upwards < -1 || upwards > 1) return std::nullopt;
    if (upwards == 1) border.push_back({low, high});
    if (upwards == -1) border.push_back({high, low});
  }
  return border;
}

class PolygonSplitter {
 public:
  PolygonSplitter(std::span<const glm::dvec2> points, std::span<const std::uint32_t> face)
      : points_(points), face_(face), corners_(find_first_visits(face)) {}

  bool split(std::vector<Corners>& triangles) {
    const auto border = find_border(corners_);
    if (!border || !insert_points() || !constrain(*border)) return false;
    for (const Delaunay::Face_handle f : delaunay_.all_face_handles()) f->info() = {};
    for (const Edge& edge : *border) {
      // Whole, and not split at a corner that touches it.
      Delaunay::Face_handle left;
      int across = 0;
      if (!delaunay_.is_edge(handles_[edge.to], handles_[edge.from], left, across)) return false;
      left->info().is_bounded[static_cast<std::size_t>(across)] = true;
      reach(left);
    }
    if (!fill() || !has_all_corners()) return false;
    for (const Delaunay::Face_handle f : inside_) {
      triangles.push_back(
          {face_[f->vertex(0)->info()], face_[f->vertex(1)->info()], face_[f->vertex(2)->info()]});
    }
    return true;
  }

 private:
  bool insert_points() {
    handles_.resize(corners_.size());
    Delaunay::Face_handle hint;
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
      if (corners_[i] != i) continue;
      handles_[i] = delaunay_.insert(Kernel::Point_2(points_[i].x, points_[i].y), hint);
      handles_[i]->info() = i;
      hint = handles_[i]->face();
      ++different_corners_;
    }
    return delaunay_.number_of_vertices() == different_corners_ && delaunay_.dimension() == 2;
  }

  bool constrain(const std::vector<Edge>& border) {
    try {
      for (const Edge& edge : border) {
        delaunay_.insert_constraint(handles_[edge.from], handles_[edge.to]);
      }
    } catch (const Delaunay::Intersection_of_constraints_exception&) {
      return false;
    }
    return delaunay_.number_of_vertices() == different_corners_;
  }

  void reach(Delaunay::Face_handle f) {
    if (f->info().is_inside) return;
    f->info().is_inside = true;
    inside_.push_back(f);
  }

  // What can be reached from the left of the border without crossing it. False where that has
  // another border than the polygon's.
  bool fill() {
    for (std::size_t i = 0; i < inside_.size(); ++i) {
      const Delaunay::Face_handle f = inside_[i];
      if (delaunay_.is_infinite(f)) return false;
      for (int across = 0; across < 3; ++across) {
        if (!f->is_constrained(across)) {
          reach(f->neighbor(across));
        } else if (!f->info().is_bounded[static_cast<std::size_t>(across)]) {
          return false;
        }
      }
    }
    return true;
  }

  bool has_all_corners() const {
    std::vector<bool> is_there(corners_.size(), false);
    std::size_t count = 0;
    for (const Delaunay::Face_handle f : inside_) {
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t corner = f->vertex(i)->info();
        count += is_there[corner] ? 0 : 1;
        is_there[corner] = true;
      }
    }
    return count == different_corners_;
  }

  std::span<const glm::dvec2> points_;
  std::span<const std::uint32_t> face_;
  std::vector<std::uint32_t> corners_;  // the polygon's, by the place where each comes first
  std::size_t different_corners_ = 0;
  Delaunay delaunay_;
  std::vector<Delaunay::Vertex_handle> handles_;
  std::vector<Delaunay::Face_handle> inside_;
};

}  // namespace

bool split_polygon(std::span<const glm::dvec2> points, std::span<const std::uint32_t> face,
                   std::vector<Corners>& triangles) {
  return PolygonSplitter(points, face).split(triangles);
}

}  // namespace spoctree
