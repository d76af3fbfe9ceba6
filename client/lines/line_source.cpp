#include "client/lines/line_source.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "common/geometry/tolerances.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

namespace {

class SourceFinder {
  static constexpr double kNone = std::numeric_limits<double>::infinity();

 public:
  SourceFinder(const Octree& tree, std::uint32_t level)
      : tree_(tree), planes_(tree.plane_set()), level_(level) {}

  void run(VisibleLine& line) {
    found_.clear();
    way_ = line.b - line.a;
    per_way_ = 1.0 / way_;
    double begin = 0;
    for (const LineStretch& stretch : line.stretches) {
      walk(line.a, begin, stretch);
      begin = stretch.end;
    }
    if (line.stretches.empty()) walk(line.a, 0, {1, line.source, {line.planes[0], line.planes[1]}});
    drop_short(2 * kShortestLine * 2 * tree_.universe.half_side / glm::length(way_));
    set_stretches(line, found_);
  }

 private:
  /// From leaf to leaf: the points a + t way, t from `begin` to the stretch's end.
  void walk(Vec3 a, double begin, const LineStretch& stretch) {
    // A hair into the material: behind the planes.
    Vec3 inwards{0.0};
    for (const PlaneRef plane : stretch.planes) inwards -= planes_[plane].normal;
    const double length = glm::length(inwards);
    start_ = a;
    if (length > kEdgeOnTolerance) start_ += inwards * (kShortestLine / length);
    // Most lines are near the one before: its path from the root is where to begin.
    const Vec3 first = start_ + begin * way_;
    const Vec3 last = start_ + stretch.end * way_;
    while (path_.size() > 1 && !(is_in(path_.back(), first) && is_in(path_.back(), last))) {
      path_.pop_back();
    }
    visit(begin, stretch.end, stretch);
  }

  /// As `visit` chooses octants.
  bool is_in(const NodeAddress& node, Vec3 point) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (!(point[axis] > wall(node.lower[axis])) ||
          point[axis] > wall(node.lower[axis] + node.size())) {
        return false;
      }
    }
    return true;
  }

  double wall(std::uint32_t index) const { return wall_coordinate(planes_.half_side(), index); }

  /// The part of a stretch from `begin` to `end`, which lies in the cube of the path's last node.
  void visit(double begin, double end, const LineStretch& stretch) {
    while (true) {
      const NodeAddress node = path_.back();
      const Level& nodes = tree_.levels[node.level];
      if (nodes.kinds[node.index] != NodeKind::Grey || node.level == level_) {
        add(node, end, stretch);
        return;
      }
      Vec3 middle;
      Vec3 borders{kNone};
      for (int axis = 0; axis < 3; ++axis) {
        middle[axis] = wall(node.lower[axis] + node.size() / 2);
        const double at = (middle[axis] - start_[axis]) * per_way_[axis];
        if (at > begin && at < end) borders[axis] = at;
      }
      if (borders[0] > borders[1]) std::swap(borders[0], borders[1]);
      if (borders[1] > borders[2]) std::swap(borders[1], borders[2]);
      if (borders[0] > borders[1]) std::swap(borders[0], borders[1]);
      const auto go_to_child_at = [&](double t) {
        const Vec3 point = start_ + t * way_;
        std::uint32_t octant = 0;
        for (int axis = 0; axis < 3; ++axis) {
          if (point[axis] > middle[axis]) octant |= 1u << static_cast<unsigned>(axis);
        }
        path_.resize(node.level + 1);
        path_.push_back(node.child(nodes.first_child[node.index], octant));
      };
      for (int k = 0; k < 3 && borders[k] < kNone; ++k) {
        go_to_child_at(0.5 * (begin + borders[k]));
        visit(begin, borders[k], stretch);
        begin = borders[k];
      }
      go_to_child_at(0.5 * (begin + end));
    }
  }

  void add(const NodeAddress& node, double end, const LineStretch& stretch) {
    const Level& nodes = tree_.levels[node.level];
    const auto own = nodes.planes_of(node.index);
    LineStretch& found = found_.emplace_back(stretch);
    found.end = end;
    found.source.kind = nodes.kinds[node.index];
    found.source.level = static_cast<std::uint8_t>(node.level);
    found.source.is_inherited =
        std::none_of(stretch.planes, stretch.planes + 2, [&](PlaneRef plane) {
          return !plane.is_wall() && std::find(own.begin(), own.end(), plane.index()) != own.end();
        });
  }

  /// Stretches shorter than `shortest` (of the line's length) go to the ones before them.
  void drop_short(double shortest) {
    std::size_t kept = 0;
    double begin = 0;
    for (const LineStretch& stretch : found_) {
      if (kept > 0 && stretch.end - begin < shortest) {
        found_[kept - 1].end = stretch.end;
      } else if (kept > 0 && begin < shortest) {
        found_[kept - 1] = stretch;
      } else {
        found_[kept++] = stretch;
      }
      begin = stretch.end;
    }
    found_.resize(kept);
  }

  const Octree& tree_;
  const PlaneSet planes_;
  const std::uint32_t level_;
  Vec3 start_{0.0};
  Vec3 way_{0.0};
  Vec3 per_way_{0.0};
  std::vector<LineStretch> found_;
  std::vector<NodeAddress> path_{NodeAddress{}};  // from the root to the node at hand
};

}  // namespace

void find_sources(VisibleLines& lines, const Octree& tree, std::uint32_t level) {
  SourceFinder finder(tree, level);
  for (VisibleLine& line : lines) finder.run(line);
}

}  // namespace spoctree
