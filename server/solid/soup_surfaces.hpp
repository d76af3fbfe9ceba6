// The connected surfaces of a polygon soup, and what they look like from afar.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

/// Faces that are connected across edges.
struct SoupSurface {
  std::uint32_t first_face = 0;
  std::size_t faces = 0;
  std::size_t triangles = 0;     ///< that the faces are divided into
  std::size_t border_edges = 0;  ///< with one face
  double border_length = 0;      ///< of these, in units of the file
  std::size_t odd_edges = 0;     ///< with three faces, five and so on
  /// Edges with several faces that do not run along it as often up as down.
  std::size_t unbalanced_edges = 0;
  double area = 0;
  glm::dvec3 area_vector{0.0};  ///< what the faces look like from all sides; zero if it is closed

  bool is_closed() const { return border_edges == 0 && odd_edges == 0; }
  /// Which part of its area its border would need at least to be closed: 1 for a flat piece.
  double flatness() const;
};

struct SoupSurfaces {
  std::vector<std::uint32_t> of_face;  ///< in the list
  std::vector<SoupSurface> list;       ///< in the order of their first faces
};

/// Which edges connect faces: all, or only those with two faces.
enum class Connection { AnyEdge, EdgeOfTwo };

/// n log n. REQUIRES: sides as from sides_by_edge.
SoupSurfaces find_surfaces(const PolygonSoup& soup, std::span<const SoupSide> sides,
                           Connection connection);

}  // namespace spoctree
