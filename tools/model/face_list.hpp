// Faces given by the coordinates of their corners, also with holes -> a polygon mesh.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <vector>

#include "tools/model/polygon_mesh.hpp"

namespace spoctree::model {

using Corners = std::vector<glm::dvec3>;
using Corners2 = std::vector<glm::dvec2>;

/// Collects the faces of one solid. Corners with equal coordinates become one point of the mesh.
/// Whoever adds the faces answers for the mesh being closed: a corner that lies on a side of
/// another face must be named there, too.
class FaceList {
 public:
  /// Adds one face, counterclockwise seen from outside; its holes clockwise. A face with holes is
  /// cut into simple polygons (see cut_holes).
  void add(const Corners& outer, const std::vector<Corners>& holes = {});

  /// Adds the quads between two copies of a loop: from[i], from[i+1], to[i+1], to[i].
  /// REQUIRES: loops of the same length, `to` being `from` moved.
  void add_walls(const Corners& from, const Corners& to);

  /// Adds the whole boundary of { (x, y, z) : (x, y) in the profile, z_low <= z <= z_high }.
  /// `profile` counterclockwise seen from above, its holes clockwise.
  void add_prism(const Corners2& profile, double z_low, double z_high,
                 const std::vector<Corners2>& holes = {});

  /// Adds a box from its lowest to its highest corner; a `hollow` one has its faces turned inward
  /// and stands for a cavity.
  void add_box(const glm::dvec3& low, const glm::dvec3& high, bool hollow = false);

  const PolygonMesh& mesh() const { return mesh_; }

 private:
  Loop weld(const Corners& corners);

  PolygonMesh mesh_;
  std::map<std::array<double, 3>, std::uint32_t> index_of_;
};

/// The points of a profile at the height z.
Corners at_height(const Corners2& profile, double z);

}  // namespace spoctree::model
