// Exact inside tests and distances against a whole solid (CGAL behind the curtain).
#pragma once

#include <memory>

#include "server/solid/solid.hpp"

namespace spoctree {

/// Queries against the boundary of a solid, in universe coordinates. Not thread-safe while its
/// search trees are being built by the first query of a kind.
class SolidQueries {
 public:
  enum class Side { Out, In, On };

  explicit SolidQueries(const Solid& solid);
  ~SolidQueries();
  SolidQueries(const SolidQueries&) = delete;
  SolidQueries& operator=(const SolidQueries&) = delete;

  /// Which side of the boundary a point lies on: exact.
  Side side_of(Vec3 point) const;
  /// Distance to the nearest point of the boundary, error below 1e-12.
  double distance(Vec3 point) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spoctree
