// Triangles that meet elsewhere than in the points and edges that they share.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "server/solid/box_tree.hpp"
#include "server/solid/first_found.hpp"
#include "server/solid/grid_mesh.hpp"

namespace spoctree {

/// Pairs are no longer looked for once there are so many.
inline constexpr std::size_t kMostSelfIntersections = 1'000'000;

/// Nor once so many pairs of triangles whose boxes overlap have been compared, and so many more for
/// each triangle: that takes seconds. Meshes of parts and scans have some 20 a triangle.
inline constexpr std::size_t kMostComparisons = 60'000'000;
inline constexpr std::size_t kMostComparisonsPerTriangle = 100;

struct SelfIntersections {
  FirstFound<std::array<std::uint32_t, 2>> pairs;  ///< the triangle with the smaller number first
  bool are_all = true;                             ///< false: a limit above ended the search
};

/// Exact for the given points. Near-linear for meshes whose triangles' boxes overlap few others;
/// the triangles around one vertex may be many.
/// REQUIRES: `boxes` holds the triangles' boxes; no triangle is degenerate; triangles that share
/// two corners share an edge.
SelfIntersections find_self_intersections(std::span<const Vec3> points,
                                          std::span<const Corners> triangles, const BoxTree& boxes);

/// The same pairs, all of them (or very many: are_all is false), each once, in no order that means
/// anything.
struct MeetingTriangles {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  bool are_all = true;
};
MeetingTriangles find_meeting_triangles(std::span<const Vec3> points,
                                        std::span<const Corners> triangles, const BoxTree& boxes);

/// Some of a surface's triangles; box i is that of triangle triangles[i].
struct SomeBoxes {
  std::vector<std::uint32_t> triangles;
  BoxTree boxes;
};
SomeBoxes boxes_of(std::span<const Vec3> points, std::span<const Corners> triangles,
                   std::vector<std::uint32_t> some);

/// Triangles that have been compared with each other already.
struct JudgedBoxes {
  const BoxTree* boxes;
  std::span<const std::uint32_t> triangles;   ///< of the boxes; empty: box i is of triangle i
  std::span<const std::uint8_t> is_outdated;  ///< by triangle: its box is no longer the right one
};

/// If find_new_self_intersections returns fewer pairs than these, they are all.
inline constexpr std::size_t kAllPairsAreFoundBelow = 1024;

/// The pairs of which at least one triangle is `changed`, or very many of them: what there is to
/// find after some triangles of a judged surface have changed. Every other triangle is in one of
/// `judged` and not outdated there. REQUIRES: as find_self_intersections.
std::vector<std::array<std::uint32_t, 2>> find_new_self_intersections(
    std::span<const Vec3> points, std::span<const Corners> triangles, const SomeBoxes& changed,
    std::span<const JudgedBoxes> judged);

/// The tree of the triangles' boxes.
BoxTree box_tree_of(std::span<const Vec3> points, std::span<const Corners> triangles);

}  // namespace spoctree
