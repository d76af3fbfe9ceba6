// A rebuilt surface as a mesh of simple polygons in model coordinates, and that mesh as OFF text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/rebuild/surface.hpp"
#include "common/geometry/universe.hpp"

namespace spoctree {

/// Simple polygons, counter-clockwise seen from outside, closed as the surface is.
struct PolygonMesh {
  std::vector<Vec3> vertices;                   ///< model coordinates
  std::vector<std::uint32_t> polygon_begin{0};  ///< polygons + 1 offsets into `corners`
  std::vector<std::uint32_t> corners;           ///< vertex indices
  std::size_t polygon_count() const { return polygon_begin.size() - 1; }
};

/// The faces of `surface` as simple polygons: a face without holes is one polygon; one with holes
/// is cut along bridges between its vertices, two per hole. No vertex is added. O(face + holes *
/// face vertices) per face.
PolygonMesh make_polygon_mesh(const Surface& surface, const Universe& universe);

/// The mesh in the OFF format, every coordinate as the shortest decimal that reads back exactly.
std::string to_off(const PolygonMesh& mesh);

}  // namespace spoctree
