// A solid as the mesh that it was made from.
#pragma once

#include "server/solid/solid.hpp"
#include "tests/support/plain_mesh.hpp"

namespace spoctree {

/// The triangles that a tree is made from, in model coordinates.
inline PlainMesh mesh_of(const Solid& solid) {
  PlainMesh mesh;
  for (const Vec3 v : solid.vertices) mesh.points.push_back(solid.universe.to_model(v));
  for (const SolidTriangle& t : solid.triangles) {
    mesh.faces.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
  }
  return mesh;
}

}  // namespace spoctree
