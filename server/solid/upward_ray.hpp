// The ray from a point straight up: whether it crosses a triangle, exactly. Counting crossings
// tells inside from outside.
#pragma once

#include <cstdint>
#include <span>

#include "server/solid/box_tree.hpp"

namespace spoctree {

/// Tells the crossings of the ray from a point along +z with one triangle after the other.
class UpwardRay {
 public:
  enum class Meets { Not, Crosses, StartsOn };

  explicit UpwardRay(Vec3 start) : start_(start) {}

  /// Whether the ray crosses the triangle, exactly, for any finite doubles. The ray is shifted
  /// sideways by less than any number, the same for every triangle, so that it never runs through
  /// an edge: with a closed surface the number of crossings is odd if and only if it starts inside.
  Meets meets(Vec3 a, Vec3 b, Vec3 c) const;

 private:
  Vec3 start_;
};

}  // namespace spoctree
