// How often the triangles of a mesh wind around a point, by CGAL's exact predicates: the judge of
// what repair makes of surfaces that overlap. It knows the mesh as CGAL reads it and nothing else.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "tests/support/plain_mesh.hpp"
#include "tests/support/random.hpp"

namespace spoctree {

class WindingJudge {
 public:
  /// Polygons are triangulated by CGAL, each on its own.
  explicit WindingJudge(const PlainMesh& mesh);
  ~WindingJudge();
  WindingJudge(const WindingJudge&) = delete;
  WindingJudge& operator=(const WindingJudge&) = delete;

  /// The signed crossings of a segment from the point to a random one outside, tried again where it
  /// meets an edge or a corner. The sign of every crossing is exact. Two segments must agree:
  /// throws std::runtime_error if they do not (the surface has a border then).
  /// REQUIRES: the point is not on the surface.
  std::int64_t winding(Vec3 point, Random& random) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace spoctree
