#include <numeric>

#include "server/silhouettes/triangle_quadtree.hpp"
#include "server/silhouettes/view_tree.hpp"

namespace spoctree {

namespace {

using Hexagon = std::array<TriangleQuadtrees::Triangle, 6>;

constexpr int kOnAxis = 6;

/// The spoke of the parent's hexagon whose middle is the octant's centre in the picture, or kOnAxis
/// for the octants in front and behind.
int spoke_of(const View& view, int octant) {
  const glm::ivec3 towards = towards_octant(octant);
  const int right = dot(view.right, towards) / 2;
  const int up = dot(view.up, towards);
  if (right == 0) return up == 0 ? kOnAxis : (up > 0 ? 2 : 5);
  return right > 0 ? (up > 0 ? 3 : 4) : (up > 0 ? 1 : 0);
}

/// An octant shows as a hexagon of six triangles, one after the other around its centre. Those of
/// its children are parts of them: around the same centre, or around the middle of a spoke, three
/// parts of the triangles on either side of it (figure 9). Octants one behind the other have the
/// same hexagon, and are one node.
class CornerTreeBuilder {
 public:
  CornerTreeBuilder(const View& view, const Mask& mask, const SilhouetteRules& rules,
                    NodePool& pool)
      : quadtrees_(mask), rules_(rules), pool_(pool) {
    for (int octant = 0; octant < 8; ++octant) {
      const glm::ivec3 from_viewer = towards_octant(octant) * view.towards_viewer;
      steps_[static_cast<std::size_t>(octant)] = {spoke_of(view, octant),
                                                  (from_viewer.x - from_viewer.y) / 2,
                                                  (from_viewer.y - from_viewer.z) / 2};
    }
    for (int depth = 0; depth < rules.max_depth; ++depth)
      known_.emplace_back(width_at(depth) * width_at(depth), nullptr);
  }

  const ColouredNode* build() { return build(0, 0, 0, {0, 1, 2, 3, 4, 5}); }

 private:
  struct Step {
    int spoke;
    int a;  ///< to the octant's centre, in coordinates of the lattice of centres
    int b;
  };

  /// Centres of a depth's hexagons have lattice coordinates of magnitude below 2^depth.
  static std::size_t width_at(int depth) { return (std::size_t{2} << depth) - 1; }

  const ColouredNode* build(int depth, int a, int b, const Hexagon& hexagon) {
    double black = 0;
    for (const auto triangle : hexagon) black += quadtrees_.black_share(triangle);
    if (black == 0) return kWhite;
    if (black == 6) return kBlack;
    if (depth == rules_.max_depth) return colour_of_mixed(black, 6, rules_.corner_fraction);
    const int most = (1 << depth) - 1;
    const std::size_t place =
        static_cast<std::size_t>(a + most) * width_at(depth) + static_cast<std::size_t>(b + most);
    const ColouredNode*& known = known_[static_cast<std::size_t>(depth)][place];
    if (known == nullptr) {
      std::array<const ColouredNode*, 8> children;
      for (std::size_t octant = 0; octant < 8; ++octant) {
        const Step& step = steps_[octant];
        children[octant] =
            build(depth + 1, 2 * a + step.a, 2 * b + step.b, child_hexagon(hexagon, step.spoke));
      }
      known = pool_.make(children);
    }
    return known;
  }

  Hexagon child_hexagon(const Hexagon& hexagon, int spoke) const {
    const auto part = [&](int p, int label) {
      return quadtrees_.part(hexagon[static_cast<std::size_t>(p)], label);
    };
    Hexagon child{};
    if (spoke == kOnAxis) {
      for (std::size_t p = 0; p < 6; ++p)
        child[p] = quadtrees_.part(hexagon[p], kCornerLabels[p].centre);
      return child;
    }
    const auto q = static_cast<std::size_t>(spoke);
    const std::size_t before = (q + 5) % 6;
    const int behind = static_cast<int>(before);
    child[q] = part(spoke, kCornerLabels[q].first);
    child[(q + 1) % 6] = part(spoke, 0);
    child[(q + 2) % 6] = part(spoke, kCornerLabels[q].centre);
    child[(q + 3) % 6] = part(behind, kCornerLabels[before].centre);
    child[(q + 4) % 6] = part(behind, 0);
    child[before] = part(behind, kCornerLabels[before].second);
    return child;
  }

  const TriangleQuadtrees quadtrees_;
  const SilhouetteRules& rules_;
  NodePool& pool_;
  std::array<Step, 8> steps_{};
  std::vector<std::vector<const ColouredNode*>> known_;  ///< of inner depths; nullptr: not decided
};

}  // namespace

const ColouredNode* build_corner_tree(const View& view, const Mask& mask,
                                      const SilhouetteRules& rules, NodePool& pool) {
  return CornerTreeBuilder(view, mask, rules, pool).build();
}

}  // namespace spoctree
