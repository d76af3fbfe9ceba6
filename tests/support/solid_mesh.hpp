// A solid as a mesh, for judges that know nothing of solids.
#pragma once

#include "server/solid/solid.hpp"
#include "tests/support/plain_mesh.hpp"

namespace spoctree {

/// The triangles that a tree is made from, in universe coordinates.
inline PlainMesh universe_mesh_of(const Solid& solid) {
  PlainMesh mesh;
  mesh.points = solid.vertices;
  for (const SolidTriangle& t : solid.triangles) {
    mesh.faces.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
  }
  return mesh;
}

/// The same in model coordinates.
inline PlainMesh mesh_of(const Solid& solid) {
  PlainMesh mesh = universe_mesh_of(solid);
  for (auto& point : mesh.points) point = solid.universe.to_model(point);
  return mesh;
}

}  // namespace spoctree
