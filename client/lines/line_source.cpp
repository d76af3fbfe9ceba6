#include "client/lines/line_source.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "common/geometry/tolerances.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

namespace {

class SourceFinder {
 public:
  SourceFinder(const Octree& tree, std::uint32_t level)
      : tree_(tree), planes_(tree.plane_set()), level_(level) {}

  void run(VisibleLine& line) {
    found_.clear();
    way_ = line.b - line.a;
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
    while (depth_ > 0 && !(is_in(path_[depth_], first) && is_in(path_[depth_], last))) --depth_;
    visit(begin, first, stretch.end, last, stretch);
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

  /// The part of a stretch from `begin` at `first` to `end` at `last`, which lies in the cube of
  /// the path's last node.
  void visit(double begin, Vec3 first, double end, Vec3 last, const LineStretch& stretch) {
    while (true) {
      const NodeAddress& node = path_[depth_];
      const Level& nodes = tree_.levels[node.level];
      if (nodes.kinds[node.index] != NodeKind::Grey || node.level == level_) {
        add(node, end, stretch);
        return;
      }
      Vec3 middle;
      for (int axis = 0; axis < 3; ++axis) {
        middle[axis] = wall(node.lower[axis] + node.size() / 2);
      }
      const std::uint32_t octant = octant_of(first, middle);
      if (octant == octant_of(last, middle)) {
        go_down(octant);
        continue;
      }
      // The part before the first wall that it crosses, then the rest.
      double border = end;
      for (int axis = 0; axis < 3; ++axis) {
        const double at = (middle[axis] - start_[axis]) / way_[axis];
        if (at > begin && at < border) border = at;
      }
      if (border == end) {
        go_down(octant_of(start_ + 0.5 * (begin + end) * way_, middle));
        continue;
      }
      const std::uint32_t depth = depth_;
      const Vec3 at_border = start_ + border * way_;
      go_down(octant_of(start_ + 0.5 * (begin + border) * way_, middle));
      visit(begin, first, border, at_border, stretch);
      depth_ = depth;
      begin = border;
      first = at_border;
    }
  }

  static std::uint32_t octant_of(Vec3 point, Vec3 middle) {
    return (point.x > middle.x ? 1u : 0u) | (point.y > middle.y ? 2u : 0u) |
           (point.z > middle.z ? 4u : 0u);
  }

  void go_down(std::uint32_t octant) {
    const NodeAddress& node = path_[depth_];
    path_[depth_ + 1] = node.child(tree_.levels[node.level].first_child[node.index], octant);
    ++depth_;
  }

  void add(const NodeAddress& node, double end, const LineStretch& stretch) {
    const Level& nodes = tree_.levels[node.level];
    const auto own = nodes.planes_of(node.index);
    LineStretch& found = found_.emplace_back(stretch);
    found.end = end;
    found.source.kind = nodes.kinds[node.index];
    found.source.level = static_cast<std::uint8_t>(node.level);
    const auto is_wall = [](PlaneRef plane) { return plane.is_wall(); };
    const auto is_own = [&](PlaneRef plane) {
      return !plane.is_wall() && std::find(own.begin(), own.end(), plane.index()) != own.end();
    };
    const PlaneRef* const end_of_planes = stretch.planes + 2;
    found.source.is_inherited = !std::all_of(stretch.planes, end_of_planes, is_wall) &&
                                std::none_of(stretch.planes, end_of_planes, is_own);
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
  std::vector<LineStretch> found_;
  NodeAddress path_[kMaxDepth + 1];  // from the root to the node at hand
  std::uint32_t depth_ = 0;
};

}  // namespace

void find_sources(VisibleLines& lines, const Octree& tree, std::uint32_t level) {
  SourceFinder finder(tree, level);
  for (VisibleLine& line : lines) finder.run(line);
}

}  // namespace spoctree
