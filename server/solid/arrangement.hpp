// Triangles that meet each other anywhere -> pieces that meet in whole edges and corners only
// (Zhou, Grinspun, Zorin, Jacobson: Mesh arrangements for solid geometry, SIGGRAPH 2016, section
// 4).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "server/solid/exact_points.hpp"
#include "server/solid/grid_mesh.hpp"

namespace spoctree {

/// More points than this are not constructed: they take seconds and some hundred megabytes.
inline constexpr std::size_t kMostConstructedPoints = 200'000;

/// What an arrangement would cost more than a file may.
struct TooEntangled : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A triangle of an arrangement: one of the given ones, or a part of it.
struct Piece {
  Corners corners;
  std::uint32_t triangle;  ///< a given one that it is a part of
  /// How many of the given triangles that it is a part of face as it does, less those that face the
  /// other way.
  std::int32_t times;
};

struct Arrangement {
  ExactPoints points;
  std::vector<Piece> pieces;
};

/// Exact. Triangles that meet no other stay what they are; of those that lie in one plane and
/// overlap, each part is one piece. n log n for n pairs of which few meet in one triangle.
/// Throws TooEntangled. REQUIRES: no degenerate triangle; `pairs` has all pairs of triangles that
/// meet elsewhere than in the points and edges that they share.
Arrangement arrange(std::span<const Vec3> points, std::span<const Corners> triangles,
                    std::span<const std::array<std::uint32_t, 2>> pairs);

}  // namespace spoctree
