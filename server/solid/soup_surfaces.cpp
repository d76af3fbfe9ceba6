#include "server/solid/soup_surfaces.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "server/solid/face_groups.hpp"

namespace spoctree {

double SoupSurface::flatness() const { return area > 0 ? glm::length(area_vector) / area : 1; }

SoupSurfaces find_surfaces(const PolygonSoup& soup, std::span<const SoupSide> sides,
                           Connection connection) {
  FaceGroups groups(soup.face_count());
  for_each_edge(sides, [&](std::span<const SoupSide> edge) {
    if (connection == Connection::EdgeOfTwo && edge.size() != 2) return;
    for (std::size_t i = 1; i < edge.size(); ++i) groups.join(edge[0].face, edge[i].face);
  });
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  SoupSurfaces surfaces;
  surfaces.of_face.assign(soup.face_count(), kNone);
  for (std::uint32_t f = 0; f < soup.face_count(); ++f) {
    const std::uint32_t group = groups.group_of(f);
    if (group == f) {
      surfaces.of_face[f] = static_cast<std::uint32_t>(surfaces.list.size());
      surfaces.list.emplace_back();
      surfaces.list.back().first_face = f;
    }
    surfaces.of_face[f] = surfaces.of_face[group];
    SoupSurface& surface = surfaces.list[surfaces.of_face[f]];
    const auto face = soup.face(f);
    ++surface.faces;
    surface.triangles += face.size() - 2;
    glm::dvec3 twice{0.0};
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      twice += glm::cross(soup.points[face[i]] - soup.points[face[0]],
                          soup.points[face[i + 1]] - soup.points[face[0]]);
    }
    surface.area += 0.5 * glm::length(twice);
    surface.area_vector += 0.5 * twice;
  }
  for_each_edge(sides, [&](std::span<const SoupSide> edge) {
    // An edge of many faces may belong to several surfaces, if only those of two connect.
    std::size_t up = 0;
    for (const SoupSide& side : edge) up += runs_up(soup, side) ? 1 : 0;
    for (std::size_t i = 0; i < edge.size(); ++i) {
      const std::uint32_t number = surfaces.of_face[edge[i].face];
      if (i > 0 && surfaces.of_face[edge[i - 1].face] == number) continue;
      SoupSurface& surface = surfaces.list[number];
      if (edge.size() == 1) {
        ++surface.border_edges;
        surface.border_length += glm::distance(soup.points[edge[0].low], soup.points[edge[0].high]);
      } else {
        if (edge.size() % 2 == 1) ++surface.odd_edges;
        if (2 * up != edge.size()) ++surface.unbalanced_edges;
      }
    }
  });
  return surfaces;
}

}  // namespace spoctree
