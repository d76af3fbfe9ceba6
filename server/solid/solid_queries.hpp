// Questions about points and a solid: inside or outside, and how far from the boundary.
#pragma once

#include <cstdint>
#include <memory>

#include "server/solid/solid.hpp"

namespace spoctree {

/// Answers from a tree over the triangles' boxes, built at construction in O(n log n). The answers
/// are about the triangles as they are on the grid, not about planes that were merged or moved
/// outwards. Queries may run at the same time.
class SolidQueries {
 public:
  enum class Side { Out, In, On };

  /// Keeps a reference: `solid` must outlive this, and its vertices and triangles must not change.
  explicit SolidQueries(const Solid& solid);
  ~SolidQueries();
  SolidQueries(const SolidQueries&) = delete;
  SolidQueries& operator=(const SolidQueries&) = delete;

  /// Exact for any finite universe coordinates, on the grid or not. The time is that of finding the
  /// triangles above the point.
  Side side_of(Vec3 point) const;

  /// The distance to the nearest triangle, in universe units, off by less than 1e-14 for points in
  /// the universe cube (relatively, for points far outside). About O(log n) near the surface.
  double distance(Vec3 point) const { return nearest(point).distance; }
  /// The distance if it is more than `limit`, else some number up to `limit`: faster, as the search
  /// ends at the first triangle that is so near.
  double distance_beyond(double limit, Vec3 point) const { return nearest(point, limit).distance; }

  /// The same, and which triangle is so near. Any triangle will do that is not farther than
  /// `near_enough`.
  struct Nearest {
    double distance = 0;
    std::uint32_t triangle = 0;
  };
  Nearest nearest(Vec3 point, double near_enough = 0) const;
  /// As accurate.
  double distance_to(std::uint32_t triangle, Vec3 point) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace spoctree
