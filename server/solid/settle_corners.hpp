// Groups that are nearly flat -> corners that lie on their groups' planes exactly, up to the grid.
#pragma once

#include "server/solid/flat_groups.hpp"

namespace spoctree {

/// Moves corners onto the planes of the groups around them. Where more planes meet in a corner than
/// a point can lie on, the corner reaches those of the largest groups, and the triangles around it
/// leave the other groups: their planes follow from their corners again.
class CornerSettler {
 public:
  /// No corner will move by `most_move` (universe units) or more. Keeps a reference to `surface`.
  CornerSettler(const FlatSurface& surface, FlatGroups groups, double most_move);

  /// The corner stays where the file has it, from the next settle() on.
  void pin(std::uint32_t vertex);

  /// Moves corners, takes triangles out of groups and fits these again until every corner is within
  /// kGridFlatness of the planes of all groups around it before it is rounded to the grid. Ends
  /// because every round takes a triangle out of a group; near-linear, as few rounds concern more
  /// than a few corners.
  void settle();

  const FlatGroups& groups() const { return groups_; }
  const std::vector<GridPoint>& points() const { return points_; }
  bool is_moved(std::uint32_t vertex) const { return points_[vertex] != surface_.points[vertex]; }

 private:
  struct Conflict {
    std::uint32_t vertex;
    std::uint32_t group;
  };

  void touch(std::uint32_t vertex);
  void touch_corners(std::uint32_t triangle);
  void settle(std::uint32_t vertex, std::vector<Conflict>& conflicts);
  void release(std::uint32_t triangle);
  void fit_again(std::uint32_t group);

  const FlatSurface& surface_;
  FlatGroups groups_;
  double most_move_;
  std::vector<GridPoint> points_;
  std::vector<std::uint32_t> triangle_at_;  // for each vertex, one of the triangles around it
  std::vector<std::uint8_t> is_pinned_;
  std::vector<std::uint8_t> is_touched_;
  std::vector<std::uint32_t> touched_;  // vertices that are to be settled (again)
  std::vector<std::uint32_t> around_;   // the groups around a vertex
};

}  // namespace spoctree
