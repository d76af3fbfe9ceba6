#include "server/solid/open_edges.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace spoctree {

namespace {

void look_inward(OpenEdge& edge, const SoupSide& side, const PolygonSoup& faces,
                 std::span<const glm::dvec3> points) {
  const auto face = faces.face(side.face);
  // Newell's normal around the first corner, as everywhere.
  glm::dvec3 normal{0.0};
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    normal += glm::cross(points[face[i]] - points[face[0]], points[face[i + 1]] - points[face[0]]);
  }
  const std::size_t i = side.corner - faces.first_corner[side.face];
  const glm::dvec3 along = points[face[(i + 1) % face.size()]] - points[face[i]];
  const glm::dvec3 inward = glm::cross(normal, along);
  const double length = glm::length(inward);
  if (!(length > 0)) return;
  edge.inward = inward / length;
  for (const std::uint32_t corner : face) {
    edge.reach = std::max(edge.reach, glm::dot(points[corner] - points[face[i]], edge.inward));
  }
}

}  // namespace

bool find_open_points(const PolygonSoup& soup, std::vector<bool>& open_points) {
  open_points.assign(soup.points.size(), false);
  bool is_any = false;
  const std::vector<SoupSide> sides = sides_by_edge(soup);
  for_each_edge(sides, [&](std::span<const SoupSide> edge) {
    if (edge.size() % 2 == 0) return;
    open_points[edge[0].low] = open_points[edge[0].high] = true;
    is_any = true;
  });
  return is_any;
}

OpenPart::OpenPart(const PolygonSoup& whole, std::vector<bool>& open_points) {
  for (std::uint32_t f = 0; f < whole.face_count(); ++f) {
    const auto face = whole.face(f);
    if (std::none_of(face.begin(), face.end(),
                     [&](std::uint32_t corner) { return open_points[corner]; })) {
      continue;
    }
    faces.corners.insert(faces.corners.end(), face.begin(), face.end());
    faces.first_corner.push_back(static_cast<std::uint32_t>(faces.corners.size()));
    origin.push_back(f);
  }
  taken_ = origin;
  find_edges(whole, open_points);
}

void OpenPart::find_edges(const PolygonSoup& whole, std::vector<bool>& open_points) {
  sides = sides_by_edge(faces);
  edges.clear();
  // Edges elsewhere may have their other faces outside of this part.
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
      ++end;
    if ((end - i) % 2 == 1 && (open_points[sides[i].low] || open_points[sides[i].high])) {
      edges.push_back({sides[i].low, sides[i].high, static_cast<std::uint32_t>(i),
                       static_cast<std::uint32_t>(end - i)});
      if (end - i == 1) look_inward(edges.back(), sides[i], faces, whole.points);
    }
    i = end;
  }
  for (const std::uint32_t corner : faces.corners) open_points[corner] = false;
  for (const OpenEdge& edge : edges) open_points[edge.low] = open_points[edge.high] = true;
}

void OpenPart::put_back(PolygonSoup& whole) const {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> first_corner{0};
  corners.reserve(whole.corners.size());
  first_corner.reserve(whole.first_corner.size());
  const auto add = [&](std::span<const std::uint32_t> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    first_corner.push_back(static_cast<std::uint32_t>(corners.size()));
  };
  std::size_t taken = 0;
  std::size_t own = 0;
  for (std::uint32_t f = 0; f < whole.face_count(); ++f) {
    if (taken == taken_.size() || taken_[taken] != f) {
      add(whole.face(f));
      continue;
    }
    ++taken;
    for (; own < origin.size() && origin[own] == f; ++own) add(faces.face(own));
  }
  whole.corners = std::move(corners);
  whole.first_corner = std::move(first_corner);
}

}  // namespace spoctree
