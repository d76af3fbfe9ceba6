// Groups that are nearly flat -> corners that lie on their groups' planes exactly, up to the grid.
#pragma once

#include "server/solid/fit_jointly.hpp"
#include "server/solid/flat_groups.hpp"

namespace spoctree {

/// Moves corners onto the planes of the groups around them. Where these do not all pass near a
/// corner, it reaches those of the largest groups, and the triangles around it leave the other
/// groups: their planes follow from their corners again.
class CornerSettler {
 public:
  /// No corner will move by `most_move` (universe units) or more. `fit` has ways that may take
  /// corners onto all planes around them; others are looked for where they do not.
  /// Keeps a reference to `surface`.
  CornerSettler(const FlatSurface& surface, FlatGroups groups, JointFit fit, double most_move);

  /// The corner stays where the file has it, from the next settle() on.
  void pin(std::uint32_t vertex);

  /// Triangles change groups, from the next settle() on: all into one, which is theirs not
  /// yet.
  void regroup(const std::vector<std::uint32_t>& triangles, std::uint32_t group);

  /// The triangles go back into the groups, or into none, that `before` has them in: equal planes,
  /// on which all corners were before any moved. From the next settle() on.
  void give_back(const std::vector<std::uint32_t>& triangles, const FlatGroups& before);

  /// Moves corners and takes triangles out of groups until every corner is within kGridFlatness of
  /// the planes of all groups around it (before it is rounded to the grid, at most). Ends because
  /// every round takes a triangle out of a group; near-linear, as few rounds concern more than a
  /// few corners. What lies in the plane of a group beside it then without belonging to it joins
  /// it.
  void settle();

  const FlatGroups& groups() const { return groups_; }
  const std::vector<GridPoint>& points() const { return points_; }
  bool is_moved(std::uint32_t vertex) const { return points_[vertex] != surface_.points[vertex]; }

 private:
  void leave_groups(const std::vector<std::uint32_t>& triangles);
  void settle_touched();
  bool adopt();
  bool is_nearly_on(const GridPlane& plane, std::uint32_t triangle) const;
  void touch(std::uint32_t vertex);
  void touch_corners(std::uint32_t triangle);
  bool is_on_all_planes(const GridPoint& point) const;
  bool follow_joint_fit(std::uint32_t vertex);
  void settle(std::uint32_t vertex, std::vector<CornerConflict>& conflicts);

  const FlatSurface& surface_;
  FlatGroups groups_;
  JointFit fit_;
  double most_move_;
  std::vector<GridPoint> points_;
  std::vector<std::uint8_t> is_pinned_;
  std::vector<std::uint8_t> is_touched_;
  std::vector<std::uint32_t> touched_;    // vertices that are to be settled (again)
  std::vector<std::uint8_t> is_adopted_;  // triangles
  std::vector<std::uint32_t> around_;     // the groups around a vertex, large ones first
};

}  // namespace spoctree
