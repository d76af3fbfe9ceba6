// First crossings of rays with a mesh, by CGAL with exact numbers: the judge of ray queries.
#pragma once

#include <memory>
#include <optional>

#include "tests/support/plain_mesh.hpp"

namespace spoctree {

class RayJudge {
 public:
  struct Crossing {
    double time = 0;   ///< in units of the direction, up to the rounding of this number
    double slope = 0;  ///< unit normal of the triangle . unit direction
    Vec3 normal{0.0};  ///< unit, outward
  };

  /// Faces are fanned out: they must be convex or triangles. Nearly plane will do.
  explicit RayJudge(const PlainMesh& mesh);
  ~RayJudge();
  RayJudge(const RayJudge&) = delete;
  RayJudge& operator=(const RayJudge&) = delete;

  /// The first point of the surface on the ray, from its origin on; nothing if there is none.
  std::optional<Crossing> first_crossing(Vec3 origin, Vec3 direction) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace spoctree
