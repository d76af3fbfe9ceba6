// Point and ray queries on any prefix of a tree, many of them: an index made once per level.
#pragma once

#include "common/tree/classify.hpp"
#include "common/tree/decision_graph.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// The points origin + t direction, t > 0, in universe coordinates.
struct Ray {
  Vec3 origin{0.0};
  Vec3 direction{0.0};
};

/// Where a ray meets the solid's boundary first, as far as the levels looked at can tell.
struct RayAnswer {
  enum class Kind : std::uint8_t {
    Miss,    ///< nowhere
    Hit,     ///< at `first` == `last`, in a face with the unit outward normal `normal`
    Between  ///< not before `first`; and not after `last`, which is infinite where it may miss
  };
  Kind kind = Kind::Miss;
  double first = 0;
  double last = 0;
  Vec3 normal{0.0};
};

/// How far a hit may lie from its face's plane, for origins in the universe cube: in universe units
/// (the cube's side is 1 to 2). Beyond it, times the largest coordinate of the origin, plus 1.
inline constexpr double kRayError = 0x1p-46;

/// Answers questions about T_level. Memory is proportional to the nodes, references and tokens of
/// levels 0..level, and so is the time to make one, as a rule (make_decision_graph). Immutable: any
/// number of threads may ask. The tree must outlive it; levels may be added to the tree.
class QueryIndex {
 public:
  /// Levels beyond the last one mean the last one. REQUIRES: a valid tree with at least one level.
  explicit QueryIndex(const Octree& tree, std::uint32_t level = static_cast<std::uint32_t>(-1));

  /// classify_point(tree, point, level), for every point. O(depth + planes that cross the leaf's
  /// cube), no allocation, unless the point lies exactly on one of those or on a wall of the leaf:
  /// then classify_point itself is asked.
  PointClass classify(Vec3 point) const;

  /// The first t > 0 at which the ray crosses the boundary: enters the solid, or leaves it if it
  /// starts inside. An origin exactly on the boundary is no hit by itself.
  ///
  /// Every crossing of the ray with a plane or wall is computed by a function of that plane or wall
  /// alone, so cells agree on it to the bit, and no ray slips through between two cells. `first` of
  /// a hit is off such that the point lies within kRayError of the face's plane. `first` and `last`
  /// of Between are moved apart by as much, so that they are true bounds.
  ///
  /// A ray that lies in faces, edges or walls, or passes through edges or vertices, is answered as
  /// a ray beside it is: one and the same at every cell and level, upwards along all axes as a
  /// rule. So are rays that pass those within kRayAside, and those within kRayInPlane of lying in a
  /// face that is not across an axis (both in units of coordinate_rounding: about 2^-40 and 2^-46
  /// for models around the origin). Others are answered as themselves.
  ///
  /// O(cells and planes met), front to back, up to the hit. REQUIRES: finite numbers, a direction
  /// other than 0.
  RayAnswer first_hit(const Ray& ray) const;

  const Octree& tree() const { return *tree_; }
  std::uint32_t level() const { return level_; }

 private:
  const Octree* tree_;
  std::uint32_t level_;
  double rounding_;  ///< coordinate_rounding(tree.universe)
  DecisionGraph graph_;
  /// The first steps of every point in one: where the way through the cells of a regular grid leads
  /// to. A power of 8, no more than there are cells.
  struct Entry {
    Step step;
    std::uint32_t size;  ///< of the cube that the step is for, in finest cells
  };
  std::vector<Entry> entries_;
  std::uint32_t entry_depth_ = 0;
};

}  // namespace spoctree
