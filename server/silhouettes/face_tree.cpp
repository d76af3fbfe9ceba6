#include "server/silhouettes/black_counts.hpp"
#include "server/silhouettes/view_tree.hpp"

namespace spoctree {

namespace {

/// A quadtree of the picture whose quadrants have two labels: of the two octants, one behind the
/// other, that project onto it.
class FaceTreeBuilder {
 public:
  FaceTreeBuilder(const View& view, const Mask& square, const SilhouetteRules& rules,
                  NodePool& pool)
      : counts_(square), rules_(rules), pool_(pool) {
    for (int octant = 0; octant < 8; ++octant) {
      const glm::ivec3 towards = towards_octant(octant);
      const int column = dot(view.right, towards) > 0 ? 1 : 0;
      const int row = dot(view.up, towards) > 0 ? 0 : 1;
      quadrant_of_[static_cast<std::size_t>(octant)] = static_cast<std::size_t>(column + 2 * row);
    }
  }

  const ColouredNode* build(int left, int top, int size, int depth) {
    const std::uint32_t black = counts_.count(left, top, size, size);
    const double all = static_cast<double>(size) * size;
    if (black == 0) return kWhite;
    if (black == all) return kBlack;
    if (depth == rules_.max_depth) return colour_of_mixed(black, all, rules_.black_fraction);
    const int half = size / 2;
    const std::array<const ColouredNode*, 4> quadrants{
        build(left, top, half, depth + 1), build(left + half, top, half, depth + 1),
        build(left, top + half, half, depth + 1), build(left + half, top + half, half, depth + 1)};
    std::array<const ColouredNode*, 8> children;
    for (std::size_t octant = 0; octant < 8; ++octant)
      children[octant] = quadrants[quadrant_of_[octant]];
    return pool_.make(children);
  }

 private:
  const BlackCounts counts_;
  const SilhouetteRules& rules_;
  NodePool& pool_;
  std::array<std::size_t, 8> quadrant_of_{};  ///< 0, 1 above, 2, 3 below; for each octant
};

}  // namespace

const ColouredNode* build_face_tree(const View& view, const Mask& square,
                                    const SilhouetteRules& rules, NodePool& pool) {
  return FaceTreeBuilder(view, square, rules, pool).build(0, 0, square.width, 0);
}

}  // namespace spoctree
