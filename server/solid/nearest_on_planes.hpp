// The point nearest to another on planes that nearly meet there.
#pragma once

#include <span>

#include "common/geometry/universe.hpp"

namespace spoctree {

/// A plane by its unit normal; `ahead` is how far the plane lies before a point, along the normal.
struct PlaneNear {
  Vec3 normal{0.0};
  double ahead = 0;
};

/// The shortest way from the point to where the planes meet: one of those that differ by less than
/// kSamePlane (sine) counts for all of them, and no more than three do: those that stand most
/// across each other. REQUIRES: finite numbers. Linear.
Vec3 way_onto_planes(std::span<const PlaneNear> planes);

inline constexpr double kSamePlane = 1e-4;

}  // namespace spoctree
