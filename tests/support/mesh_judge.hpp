// Inside tests and distances by CGAL, on a mesh alone: the judge of trees and rebuilt surfaces.
#pragma once

#include <memory>
#include <vector>

#include "tests/support/plain_mesh.hpp"
#include "tests/support/random.hpp"

namespace spoctree {

class MeshJudge {
 public:
  struct Sample {
    Vec3 point{0.0};
    Vec3 normal{0.0};
  };

  /// Polygons are triangulated; they must be simple and nearly plane. The surface need not be a
  /// manifold for distances, but for `is_inside`.
  explicit MeshJudge(const PlainMesh& mesh);
  ~MeshJudge();
  MeshJudge(const MeshJudge&) = delete;
  MeshJudge& operator=(const MeshJudge&) = delete;

  /// Exact predicates. REQUIRES: the point is not on the surface.
  bool is_inside(Vec3 point) const;
  /// From the surface.
  double distance(Vec3 point) const;

  /// A point of the surface; every part of it is as likely as its area is large.
  Sample sample(Random& random) const;
  /// A point of a triangle chosen without regard to its size, a third of them on its edges.
  Sample sample_triangle(Random& random) const;

  Vec3 lower() const;
  Vec3 upper() const;
  double diagonal() const;

  /// The largest distance of `from`'s vertices and of points sampled on its faces (of every
  /// triangle, and `samples` by area) from this surface.
  double farthest(const MeshJudge& from, std::size_t samples, Random& random) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace spoctree
