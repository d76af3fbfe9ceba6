// A square, minus convex polygons one after the other -> what is left of it.
#pragma once

#include <span>
#include <vector>

#include "client/lines/half_plane.hpp"

namespace spoctree {

/// Keeps its memory from one square to the next.
class SquareRemainder {
 public:
  /// All of the square is left.
  void start(Vec2 lower, double side);

  /// Takes the common part of half-planes away. Time linear in the parts that are left, each of
  /// which it can divide into as many as there are half-planes.
  void take_away(std::span<const HalfPlane> polygon);

  /// Nothing is left but slivers without area.
  bool is_empty() const { return parts_.empty(); }

 private:
  using Polygon = std::vector<Vec2>;

  double nothing_ = 0;
  std::vector<Polygon> parts_;  // convex, without overlaps
  Polygon within_, cut_;
};

}  // namespace spoctree
