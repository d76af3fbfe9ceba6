// The part of a soup around its open edges.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

/// An edge with an odd number of faces.
struct OpenEdge {
  std::uint32_t low;         ///< the smaller of its points
  std::uint32_t high;        ///< the larger
  std::uint32_t first_side;  ///< in OpenPart::sides
  std::uint32_t side_count;
  /// If there is one face: the direction from the edge into it, a unit vector, and how far it
  /// reaches; zero if there are more.
  glm::dvec3 inward{0.0};
  double reach = 0;
};

/// The faces at the ends of open edges, with the point numbers of the whole, which they can replace
/// when they have been changed.
class OpenPart {
 public:
  /// `open_points` says which points open edges may end in; it gets smaller or stays.
  OpenPart(const PolygonSoup& whole, std::vector<bool>& open_points);

  /// Finds the open edges anew. n log n.
  void find_edges(const PolygonSoup& whole, std::vector<bool>& open_points);

  /// The whole with this part in the place of what it was made from.
  void put_back(PolygonSoup& whole) const;

  PolygonSoup faces;                  ///< without points
  std::vector<std::uint32_t> origin;  ///< of each face: the face of the whole that it is from
  std::vector<SoupSide> sides;        ///< of `faces`
  std::vector<OpenEdge> edges;        ///< sorted by their points

 private:
  std::vector<std::uint32_t> taken_;  // faces of the whole, in order
};

/// Marks the ends of edges with an odd number of sides; false if there are none. n log n.
bool find_open_points(const PolygonSoup& soup, std::vector<bool>& open_points);

}  // namespace spoctree
