// Tree -> empty space as convex cells joined by openings. After C. B. Jones, A new approach to the
// 'hidden line' problem, Computer Journal 14 (3), 1971, where the cells were made by hand and the
// eye stayed in one of them.
#pragma once

#include <vector>

#include "client/cells/openings.hpp"
#include "client/cells/space_partition.hpp"
#include "client/lines/crease_parts.hpp"
#include "common/tree/pieces.hpp"

namespace spoctree {

struct EmptySpaceOptions {
  /// T_level; levels beyond the tree mean its last level.
  std::uint32_t level = static_cast<std::uint32_t>(-1);
  /// Neighbours become one cell where that is convex, too.
  bool merges_cells = true;
};

/// What is empty in the universe cube, as disjoint convex cells; what is around the cube is no
/// cell, but has openings into those at its walls.
class EmptySpace {
 public:
  /// REQUIRES: a valid tree (validate.hpp) with at least one level, which outlives this. Throws
  /// BadInput if there is more of anything than can be counted, or what `progress` throws.
  explicit EmptySpace(const Octree& tree, const EmptySpaceOptions& options = {},
                      const ProgressShare& progress = {});

  const Octree& tree() const { return tree_; }
  const std::vector<Polyhedron>& cells() const { return cells_; }
  const Openings& openings() const { return openings_; }
  /// Before they were merged.
  std::size_t cells_of_partition() const { return cell_of_.size(); }
  double material_volume() const { return partition_.material_volume; }

  /// The cells that contain a point (any finite doubles), by ascending numbers: exactly one, but on
  /// their borders, where it is all that meet there; none in material. kOuterSpace alone if the
  /// point, or direction, is outside the universe cube. By way of the partition: time about
  /// O(depth).
  ///
  /// With a `reach`, planes as near as that to the point count as its own: cells on both sides of
  /// them are found.
  std::vector<std::uint32_t> find_cells(const Viewpoint& eye, double reach = 0) const;

  /// The same for an eye that has moved from a point of cell `last`: goes through openings along
  /// the way while that is in empty space. O(cells on the way), and find_cells where it ends in
  /// none, or on a border.
  std::vector<std::uint32_t> find_cells(Vec3 eye, std::uint32_t last, Vec3 last_eye) const;

  /// Calls visit(cell, part) for each cell that a crease touches: is nearer to than `reach`.
  template <class Visit>
  void for_each_cell_of(const Crease& crease, std::uint32_t number, double reach,
                        Visit&& visit) const;

 private:
  bool contains(std::uint32_t cell, Vec3 point, bool strictly) const;

  const Octree& tree_;
  const PlaneSet planes_;
  SpacePartition partition_;
  std::vector<std::uint32_t> cell_of_;
  std::vector<Polyhedron> cells_;
  Openings openings_;
};

template <class Visit>
void EmptySpace::for_each_cell_of(const Crease& crease, std::uint32_t number, double reach,
                                  Visit&& visit) const {
  struct Open {
    SpacePartition::Child at;
    Interval interval;
  };
  const Vec3 way = crease.b - crease.a;
  const double length = glm::length(way);
  std::vector<Open> open{{partition_.root, {0, 1}}};
  while (!open.empty()) {
    const Open part = open.back();
    open.pop_back();
    if (part.at == SpacePartition::kMaterial) continue;
    if (SpacePartition::is_empty_cell(part.at)) {
      visit(cell_of_[SpacePartition::cell_of(part.at)], CreasePart{number, part.interval});
      continue;
    }
    const SpacePartition::Split& split = partition_.splits[static_cast<std::size_t>(part.at)];
    const Plane plane = planes_[split.plane];
    const double start = glm::dot(plane.normal, crease.a) - plane.offset;
    const double step = glm::dot(plane.normal, way);
    for (const bool outside : {true, false}) {
      // Leaves of the interval where this is at most `reach`.
      const double sign = outside ? -1 : 1;
      Interval kept = part.interval;
      const double at_begin = sign * (start + kept.begin * step) - reach;
      const double at_end = sign * (start + kept.end * step) - reach;
      if (at_begin > 0 && at_end > 0) continue;
      if (at_begin > 0) kept.begin -= at_begin / (sign * step);
      if (at_end > 0) kept.end -= at_end / (sign * step);
      // What touches an edge or a corner only is in other cells, too.
      const bool is_whole = !(at_begin > 0) && !(at_end > 0);
      if (!is_whole && (kept.end - kept.begin) * length <= 4 * reach) continue;
      open.push_back({outside ? split.outside : split.inside, kept});
    }
  }
}

}  // namespace spoctree
