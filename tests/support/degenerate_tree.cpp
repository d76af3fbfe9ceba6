#include "tests/support/degenerate_tree.hpp"

#include <algorithm>

#include "tests/support/grid_planes.hpp"

namespace spoctree {

namespace {

/// A node that is still to be drawn.
struct Place {
  Vec3 centre;
  double half_side;
  std::vector<std::uint32_t> ancestors;  ///< planes that must not be repeated
};

class TreeMaker {
 public:
  TreeMaker(std::uint64_t seed, std::uint32_t levels) : random_(seed), levels_(levels) {}

  Octree make() {
    std::vector<Place> places{{Vec3{0.0}, 1.0, {}}};
    while (!places.empty()) {
      std::vector<Place> next;
      Level& level = tree_.levels.emplace_back();
      for (const Place& place : places) append(level, place, next);
      places = std::move(next);
    }
    return std::move(tree_);
  }

 private:
  void append(Level& level, const Place& place, std::vector<Place>& next) {
    const bool is_root = tree_.levels.size() == 1;
    const bool splits = tree_.levels.size() < levels_ && (is_root || random_.chance(0.3));
    constexpr NodeKind kLeaves[] = {NodeKind::White, NodeKind::Black, NodeKind::Convex,
                                    NodeKind::Concave, NodeKind::Vertex};
    constexpr std::uint32_t kFewest[kNodeKindCount] = {0, 0, 0, 1, 2, 3};
    const NodeKind kind = splits ? NodeKind::Grey : kLeaves[random_.below(5)];
    std::uint32_t count = kFewest[static_cast<int>(kind)];
    if (kind != NodeKind::White && kind != NodeKind::Black) count += random_.below(2);
    std::vector<std::uint32_t> planes;
    while (planes.size() < count) planes.push_back(draw_plane(place, planes));
    std::vector<std::uint32_t> tokens;
    if (kind == NodeKind::Vertex) draw_expression(tokens, count, 0);
    level.append(kind, planes, tokens);
    if (!splits) return;
    planes.insert(planes.end(), place.ancestors.begin(), place.ancestors.end());
    const double half = place.half_side / 2;
    for (unsigned octant = 0; octant < 8; ++octant) {
      const Vec3 shift{octant & 1 ? half : -half, octant & 2 ? half : -half,
                       octant & 4 ? half : -half};
      next.push_back({place.centre + shift, half, planes});
    }
  }

  std::uint32_t draw_plane(const Place& place, const std::vector<std::uint32_t>& own) {
    const auto count = static_cast<std::uint32_t>(tree_.planes.size());
    if (count > 0 && random_.chance(0.3)) {
      const std::uint32_t old = random_.below(count);
      const auto has = [&](const std::vector<std::uint32_t>& planes) {
        return std::find(planes.begin(), planes.end(), old) != planes.end();
      };
      if (!has(own) && !has(place.ancestors)) return old;
    }
    tree_.planes.push_back(
        random_degenerate_plane(random_, place.centre, place.half_side, tree_.planes));
    return count;
  }

  void draw_expression(std::vector<std::uint32_t>& tokens, std::uint32_t plane_count, int depth) {
    if (depth == 4 || (depth > 0 && random_.chance(0.3))) {
      tokens.push_back(random_.chance(0.5) ? kInToken : kOutToken);
      return;
    }
    tokens.push_back(kFirstPlaneToken + random_.below(plane_count));
    draw_expression(tokens, plane_count, depth + 1);
    draw_expression(tokens, plane_count, depth + 1);
  }

  Random random_;
  const std::uint32_t levels_;
  Octree tree_;
};

}  // namespace

Octree degenerate_tree(std::uint64_t seed, std::uint32_t levels) {
  return TreeMaker(seed, levels).make();
}

}  // namespace spoctree
