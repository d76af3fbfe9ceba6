// A walk through a tree's GREY regions -> their volumes, and those that may hold a level's largest
// error.
#pragma once

#include <vector>

#include "common/tree/pieces.hpp"
#include "server/build/build_octree.hpp"
#include "server/build/order_free_sum.hpp"

namespace spoctree {

/// What is to be known of one level's GREY regions. Universe units.
struct GreyRegions {
  /// A region, and a bound of how far its points are from the solid.
  struct Candidate {
    double bound;
    NodeAddress node;
    Polyhedron region;
  };

  OrderFreeSum volume;
  /// Some point of a region is so far from the solid.
  double attained = 0;
  /// The regions whose bound is more than kErrorBoundRatio times what was attained before.
  std::vector<Candidate> candidates;

  /// Moves those of `other` to the end.
  void add(GreyRegions&& other);
};

/// The corner of a GREY node's region that is farthest from the node's witness triangle, and how
/// far that is: nothing in the region is farther from the solid, as the distance from a convex set
/// is convex.
struct Reach {
  double bound = 0;
  const PolyhedronVertex* farthest = nullptr;
};
Reach reach_of(const BuiltOctree& built, const Solid& solid, const NodeAddress& grey_node,
               const Polyhedron& region);

/// Surveys the GREY nodes above `end_level` that a walk leads to. Not thread-safe: one for each
/// thread.
class LevelSurvey : public PieceVisitor {
 public:
  static constexpr auto kAllLevels = static_cast<std::uint32_t>(-1);

  /// REQUIRES: the arguments outlive this.
  LevelSurvey(const BuiltOctree& built, const Solid& solid, const SolidQueries& queries,
              std::uint32_t end_level)
      : built_(built),
        solid_(solid),
        queries_(queries),
        end_level_(end_level),
        levels_(built.tree.levels.size()) {}

  bool enter(const NodeAddress& address, NodeKind, const Polyhedron&) override {
    return address.level < end_level_;
  }
  void inner(const NodeAddress& address, const Polyhedron& region) override;
  void piece(const NodeAddress&, NodeKind, std::uint32_t, const Polyhedron&) override {}

  /// Fewer regions are in question if it is known what others have attained.
  void set_attained(const std::vector<GreyRegions>& levels) {
    for (std::size_t k = 0; k < levels_.size(); ++k) levels_[k].attained = levels[k].attained;
  }
  std::vector<GreyRegions>& levels() { return levels_; }

 private:
  const BuiltOctree& built_;
  const Solid& solid_;
  const SolidQueries& queries_;
  const std::uint32_t end_level_;
  std::vector<GreyRegions> levels_;
};

}  // namespace spoctree
