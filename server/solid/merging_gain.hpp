// What merging did to a surface, part by part -> the parts where it was not worth it.
#pragma once

#include "server/solid/flat_groups.hpp"

namespace spoctree {

/// Weighs what merging has changed against what it saves.
///
/// A triangle is changed if its plane is another one than before, or a corner of it has moved.
/// Changed triangles around a corner that moved, or of one plane before or now, belong together:
/// they make up the parts, which do not depend on each other. How many planes a part saves is
/// counted exactly, but that planes which became equal by chance count twice.
class MergingGain {
 public:
  /// `before` are the groups without any merging but that of what is in one plane already. Keeps
  /// a reference to `surface`.
  MergingGain(const FlatSurface& surface, FlatGroups before);

  /// The changed triangles of the parts that save less than 1 / kLeastGain of the planes they
  /// change, in order. Near-linear.
  std::vector<std::uint32_t> find_wasted(const FlatGroups& now,
                                         std::span<const GridPoint> points) const;

  const FlatGroups& before() const { return before_; }

  static constexpr std::uint64_t kLeastGain = 64;

 private:
  bool is_plane_changed(const FlatGroups& now, std::uint32_t triangle) const;

  const FlatSurface& surface_;
  FlatGroups before_;
  std::vector<GridPlane> planes_;             // of the triangles before
  std::vector<std::uint32_t> plane_numbers_;  // the same, equal for equal planes
  std::size_t distinct_planes_ = 0;
};

/// The groups of triangles that are in one plane already, up to the grid. n log n.
FlatGroups find_groups_in_planes(const FlatSurface& surface);

}  // namespace spoctree
