#include "tests/support/random_tree.hpp"

#include <algorithm>

namespace spoctree::testing {

namespace {

/// What a node has above it, and where it lies.
struct Place {
  Vec3 centre;
  double half_side;
  std::vector<std::uint32_t> ancestors_planes;
};

class TreeMaker {
 public:
  TreeMaker(RandomSource& random, const RandomTreeOptions& options)
      : random_(random), options_(options) {}

  Octree make() {
    tree_.universe.center = random_.uniform_vector(-10, 10);
    tree_.universe.scale_exponent = random_.between(-3, 5);
    // In degenerate trees cell corners must lie on a coarse grid.
    tree_.universe.half_side =
        options_.degenerate ? 1.0 : std::ldexp(random_.between((1 << 19) + 1, 1 << 20), -20);
    std::vector<Place> places{{Vec3{0.0}, tree_.universe.half_side, {}}};
    for (std::uint32_t depth = 0; depth < options_.levels && !places.empty(); ++depth) {
      places = append_level(depth, places);
    }
    return std::move(tree_);
  }

 private:
  std::vector<Place> append_level(std::uint32_t depth, const std::vector<Place>& places) {
    Level level;
    std::vector<Place> next;
    for (const Place& place : places) {
      const NodeKind kind = random_kind(depth);
      std::vector<std::uint32_t> planes = random_planes(kind, place);
      std::vector<std::uint32_t> tokens;
      if (kind == NodeKind::Vertex) {
        std::vector<std::uint32_t> unused(planes.size());
        for (std::uint32_t i = 0; i < unused.size(); ++i) unused[i] = i;
        append_expression(tokens, unused);
      }
      level.append(kind, planes, tokens);
      if (kind != NodeKind::Grey) continue;
      planes.insert(planes.end(), place.ancestors_planes.begin(), place.ancestors_planes.end());
      for (unsigned octant = 0; octant < 8; ++octant) {
        const double half = place.half_side / 2;
        const Vec3 shift{octant & 1 ? half : -half, octant & 2 ? half : -half,
                         octant & 4 ? half : -half};
        next.push_back({place.centre + shift, half, planes});
      }
    }
    // Numbers that a builder could have stated, though it did not: none of them is looked at here.
    level.statement = {std::ldexp(1.0, -static_cast<int>(depth)), 1.0 * depth, 100.0 - depth};
    tree_.levels.push_back(std::move(level));
    return next;
  }

  NodeKind random_kind(std::uint32_t depth) {
    const bool may_be_grey = depth + 1 < options_.levels || !options_.complete;
    if (may_be_grey && (random_.chance(options_.grey_share) || (depth == 0 && options_.levels > 1)))
      return NodeKind::Grey;
    constexpr NodeKind kLeaves[] = {NodeKind::White, NodeKind::Black, NodeKind::Convex,
                                    NodeKind::Concave, NodeKind::Vertex};
    return kLeaves[random_.below(5)];
  }

  std::vector<std::uint32_t> random_planes(NodeKind kind, const Place& place) {
    std::uint32_t fewest = 0;
    if (kind == NodeKind::White || kind == NodeKind::Black) return {};
    if (kind == NodeKind::Convex) fewest = 1;
    if (kind == NodeKind::Concave) fewest = 2;
    if (kind == NodeKind::Vertex) fewest = 3;
    const std::uint32_t most = std::max(fewest, options_.largest_plane_count);
    const std::uint32_t count = fewest + random_.below(most - fewest + 1);
    std::vector<std::uint32_t> planes;
    while (planes.size() < count) {
      const auto is_taken = [&](std::uint32_t plane) {
        return std::find(planes.begin(), planes.end(), plane) != planes.end() ||
               std::find(place.ancestors_planes.begin(), place.ancestors_planes.end(), plane) !=
                   place.ancestors_planes.end();
      };
      // Now and then a plane that another node has already.
      if (!tree_.planes.empty() && random_.chance(0.2)) {
        const auto old = random_.below(static_cast<std::uint32_t>(tree_.planes.size()));
        if (!is_taken(old)) {
          planes.push_back(old);
          continue;
        }
      }
      planes.push_back(static_cast<std::uint32_t>(tree_.planes.size()));
      tree_.planes.push_back(options_.degenerate ? degenerate_plane(place) : plane_in(place));
    }
    return planes;
  }

  Plane plane_in(const Place& place) {
    const Vec3 normal = random_.direction();
    return plane_through(normal, place.centre + random_.uniform_vector(-1, 1) * place.half_side);
  }

  /// REQUIRES: cells of half side 2^-k with k <= 8.
  Plane degenerate_plane(const Place& place) {
    const Vec3 corner =
        place.centre + place.half_side * Vec3{random_.between(-1, 1), random_.between(-1, 1),
                                              random_.between(-1, 1)};
    switch (random_.below(5)) {
      case 0:  // through a corner, an edge's or a face's middle, or the centre of the cell
        return random_plane_exactly_through(random_, corner, 10);
      case 1: {  // the same, and in a wall or parallel to it
        Plane plane;
        const int axis = random_.between(0, 2);
        plane.normal[axis] = 1;
        plane.offset = corner[axis];
        return random_.chance(0.5) ? plane : plane.flipped();
      }
      case 2: {  // through an edge, a diagonal, ...
        int direction[3] = {0, 0, 0};
        while (direction[0] == 0 && direction[1] == 0 && direction[2] == 0) {
          for (int& component : direction) component = random_.between(-1, 1);
        }
        return random_plane_exactly_through_line(random_, corner, 7, direction);
      }
      case 3:  // an older plane once more, either way round, under a new number
        if (!tree_.planes.empty()) {
          const Plane& old =
              tree_.planes[random_.below(static_cast<std::uint32_t>(tree_.planes.size()))];
          return random_.chance(0.5) ? old : old.flipped();
        }
        [[fallthrough]];
      default:
        return plane_in(place);
    }
  }

  /// An expression that splits by each of `unused` at most once on any way down.
  void append_expression(std::vector<std::uint32_t>& tokens, std::vector<std::uint32_t> unused) {
    if (unused.empty() || (!tokens.empty() && random_.chance(0.25))) {
      tokens.push_back(random_.chance(0.5) ? kInToken : kOutToken);
      return;
    }
    const std::uint32_t chosen = random_.below(static_cast<std::uint32_t>(unused.size()));
    tokens.push_back(kFirstPlaneToken + unused[chosen]);
    unused.erase(unused.begin() + chosen);
    append_expression(tokens, unused);
    append_expression(tokens, unused);
  }

  RandomSource& random_;
  const RandomTreeOptions& options_;
  Octree tree_;
};

}  // namespace

Octree random_tree(RandomSource& random, const RandomTreeOptions& options) {
  return TreeMaker(random, options).make();
}

}  // namespace spoctree::testing
