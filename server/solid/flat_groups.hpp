// Triangles into groups that are to lie in one plane.
#pragma once

#include <optional>

#include "server/solid/flat_surface.hpp"
#include "server/solid/flat_tolerance.hpp"

namespace spoctree {

/// Triangles that are to lie in one plane, connected or not.
struct FlatGroup {
  GridPlane plane;
  double area = 0;        ///< universe units
  bool is_exact = true;   ///< the planes of all its triangles are equal to `plane` already
  bool is_flat = true;    ///< all its corners are on `plane` already, up to the grid
  bool is_loose = false;  ///< the plane may move although they are
  std::vector<std::uint32_t> triangles;

  bool may_move() const { return !is_flat || is_loose; }
};

struct FlatGroups {
  std::vector<FlatGroup> groups;           ///< each of at least two triangles
  std::vector<std::uint32_t> of_triangle;  ///< kNone: in no group
};

/// Neighbours that are flat within the tolerance (grow_patches), patches of these in one plane
/// within the tolerance (share_planes), and triangles anywhere whose planes are equal already. That
/// single triangles far from each other lie in one plane within a tolerance says nothing about
/// them: of the many small ones of a scan, some always do. n log n.
FlatGroups find_flat_groups(const FlatSurface& surface, double tolerance);

/// The same within tolerance.spread, and where there was rounding, with those joined that were flat
/// before it (join_rounded), unless that saves next to no group.
struct FlatAndRoundedGroups {
  FlatGroups flat;
  std::optional<FlatGroups> rounded;
};
FlatAndRoundedGroups find_flat_and_rounded_groups(const FlatSurface& surface,
                                                  const FlatTolerance& tolerance);

/// How many planes a surface has whose groups are in one plane each.
std::size_t count_planes(const FlatGroups& groups);

/// A corner and a group around it on whose plane it cannot lie.
struct CornerConflict {
  std::uint32_t vertex;
  std::uint32_t group;
};

/// Takes the triangles around the corners out of the groups. A group of which less than two are
/// left falls apart; the planes of the others stay. Returns the triangles that are in no group any
/// more. Linear in the triangles around the corners and in the groups, where the conflicts of a
/// corner stand together.
std::vector<std::uint32_t> release(const FlatSurface& surface, FlatGroups& groups,
                                   std::span<const CornerConflict> conflicts);

/// Takes the triangles that are in other groups by now out of this group's list; if less than two
/// are left, it falls apart. Returns the triangles that are in no group any more. Linear.
std::vector<std::uint32_t> drop_strangers(FlatGroups& groups, std::uint32_t group);

/// Fills `groups_around` with the groups of the triangles around the vertex, in order.
void collect_groups_around(const FlatSurface& surface, const FlatGroups& groups,
                           std::uint32_t vertex, std::vector<std::uint32_t>& groups_around);

/// Fits the group's plane to its triangles again.
void fit_again(const FlatSurface& surface, FlatGroup& group);

}  // namespace spoctree
