// The boundary of a solid as corner points and polygons, and its text in the OFF format.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace spoctree::model {

using Loop = std::vector<std::uint32_t>;  ///< corners of a closed polyline, as indices of points

/// A closed polygon mesh: every directed edge occurs in one face, and its reverse in one other
/// face. Each face is a simple planar polygon, its corners counterclockwise seen from outside.
/// Points in millimetres, right-handed, z up.
struct PolygonMesh {
  std::vector<glm::dvec3> points;
  std::vector<Loop> faces;
};

/// The mesh as an OFF file: counts of vertices, faces and edges, then a line per point and per
/// face. Numbers are the shortest decimals that read back as the same doubles. O(size).
std::string to_off(const PolygonMesh& mesh);

}  // namespace spoctree::model
