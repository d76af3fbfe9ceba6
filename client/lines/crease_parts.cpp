#include "client/lines/crease_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace spoctree {

/// Hands parts down from node to node.
class CreaseParts::Distributor {
 public:
  Distributor(const Octree& tree, std::uint32_t level, std::span<const Crease> creases,
              double tolerance, const ProgressShare& progress, std::size_t most,
              CreaseParts& result)
      : tree_(tree),
        level_(level),
        creases_(creases),
        tolerance_(tolerance),
        progress_(progress),
        most_(most),
        result_(result),
        handed_down_(level + 1) {}

  void finish() { progress_.tell(); }

  /// Empties `parts`. A share of `work` is done then.
  void visit(const NodeAddress& node, std::vector<CreasePart>& parts, double work) {
    if (parts.empty()) return;
    const Level& level = tree_.levels[node.level];
    if (level.kinds[node.index] != NodeKind::Grey || node.level == level_) {
      small_count(result_.parts_.size() + parts.size(), "parts of creases", most_);
      result_.ranges_[node.level][node.index] = {static_cast<std::uint32_t>(result_.parts_.size()),
                                                 static_cast<std::uint32_t>(parts.size())};
      progress_.add(work);
      result_.parts_.insert(result_.parts_.end(), parts.begin(), parts.end());
      parts.clear();
      return;
    }
    auto& buckets = handed_down_[node.level];
    Vec3 middle;
    for (int axis = 0; axis < 3; ++axis) {
      middle[axis] = wall_coordinate(tree_.universe.half_side, node.lower[axis] + node.size() / 2);
    }
    for (const CreasePart& part : parts) divide(part, middle, buckets);
    parts.clear();
    std::size_t handed_down = 0;
    for (const auto& bucket : buckets) handed_down += bucket.size();
    const double per_part = work * per_item(handed_down);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      visit(node.child(level.first_child[node.index], octant), buckets[octant],
            per_part * static_cast<double>(buckets[octant].size()));
    }
  }

 private:
  using Buckets = std::array<std::vector<CreasePart>, 8>;

  void divide(const CreasePart& part, Vec3 middle, Buckets& buckets) const {
    const Crease& crease = creases_[part.crease];
    const Vec3 along = crease.b - crease.a;
    const Vec3 begin = crease.a + part.interval.begin * along - middle;
    const Vec3 end = crease.a + part.interval.end * along - middle;
    unsigned upper = 0;     // the axes along which the upper half is touched
    unsigned only_one = 0;  // the axes along which one half is
    for (int axis = 0; axis < 3; ++axis) {
      const bool in_upper = std::max(begin[axis], end[axis]) >= -tolerance_;
      const bool in_lower = std::min(begin[axis], end[axis]) <= tolerance_;
      if (in_upper) upper |= 1u << axis;
      if (in_upper != in_lower) only_one |= 1u << axis;
    }
    if (only_one == 7) {
      buckets[upper].push_back(part);
      return;
    }
    const double length = glm::length(along);
    for (unsigned octant = 0; octant < 8; ++octant) {
      if (((octant ^ upper) & only_one) != 0) continue;
      Interval inside = part.interval;
      for (int axis = 0; axis < 3; ++axis) {
        if ((only_one >> axis & 1) != 0) continue;
        const double sign = (octant >> axis & 1) != 0 ? 1 : -1;
        clip(sign * (crease.a[axis] - middle[axis]), sign * along[axis], inside);
      }
      // What only touches an edge or a corner of the cube is in the next cube, too.
      const bool is_whole = inside.begin == part.interval.begin && inside.end == part.interval.end;
      if (is_whole || (inside.end - inside.begin) * length > 4 * tolerance_) {
        buckets[octant].push_back({part.crease, inside});
      }
    }
  }

  /// Leaves of the interval where start + t step >= -tolerance.
  void clip(double start, double step, Interval& interval) const {
    const double at_begin = start + interval.begin * step + tolerance_;
    const double at_end = start + interval.end * step + tolerance_;
    if (at_begin < 0 && at_end < 0) {
      interval.end = interval.begin;
    } else if (at_begin < 0) {
      interval.begin -= at_begin / step;
    } else if (at_end < 0) {
      interval.end -= at_end / step;
    }
  }

  const Octree& tree_;
  const std::uint32_t level_;
  const std::span<const Crease> creases_;
  const double tolerance_;
  ProgressCounter progress_;
  const std::size_t most_;
  CreaseParts& result_;
  std::vector<Buckets> handed_down_;  // by level
};

CreaseParts::CreaseParts(const Octree& tree, std::uint32_t level, std::span<const Crease> creases,
                         double tolerance, const ProgressShare& progress, std::size_t most) {
  level = static_cast<std::uint32_t>(std::min<std::size_t>(level, tree.levels.size() - 1));
  ranges_.resize(level + 1);
  for (std::uint32_t k = 0; k <= level; ++k) ranges_[k].resize(tree.levels[k].size());
  std::vector<CreasePart> all;
  small_count(creases.size(), "creases", most);
  all.reserve(creases.size());
  for (std::uint32_t k = 0; k < creases.size(); ++k) all.push_back({k, {0, 1}});
  Distributor distributor(tree, level, creases, tolerance, progress, most, *this);
  distributor.visit({}, all, 1);
  distributor.finish();
}

}  // namespace spoctree
