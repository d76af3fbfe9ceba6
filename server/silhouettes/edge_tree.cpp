#include "server/silhouettes/black_counts.hpp"
#include "server/silhouettes/view_tree.hpp"

namespace spoctree {

namespace {

/// A picture that is divided in two ways at once: into four quadrants with one label each, and into
/// two centre squares with two labels each. Both lie on the columns of half a square, and two ways
/// may lead to the same square, which is then one node.
class EdgeTreeBuilder {
 public:
  EdgeTreeBuilder(const View& view, const Mask& square, const SilhouetteRules& rules,
                  NodePool& pool)
      : side_(square.width), counts_(square), rules_(rules), pool_(pool) {
    for (int octant = 0; octant < 8; ++octant) {
      const glm::ivec3 towards = towards_octant(octant);
      // Two axes span the width, each octant half of it: to the left, in the centre, to the right.
      const int step = 1 + dot(view.right, towards) / 2;
      const int row = dot(view.up, towards) > 0 ? 0 : 1;
      part_of_[static_cast<std::size_t>(octant)] = static_cast<std::size_t>(step + 3 * row);
    }
    for (int depth = 0; depth < rules.max_depth; ++depth)
      known_.emplace_back(columns_at(depth) << depth, nullptr);
  }

  const ColouredNode* build() { return build(0, 0, 0); }

 private:
  /// Squares of a depth that begin in different columns: one every half square.
  static std::size_t columns_at(int depth) { return (std::size_t{2} << depth) - 1; }

  /// The square `column` half squares from the left and `row` squares from the top.
  const ColouredNode* build(int depth, std::size_t column, std::size_t row) {
    if (depth == rules_.max_depth) return decide(depth, column, row);
    const ColouredNode*& known =
        known_[static_cast<std::size_t>(depth)][row * columns_at(depth) + column];
    if (known == nullptr) known = decide(depth, column, row);
    return known;
  }

  const ColouredNode* decide(int depth, std::size_t column, std::size_t row) {
    const int size = side_ >> depth;
    const int top = static_cast<int>(row) * size;
    if (size == 1 && column % 2 == 1) {
      // The centre square of 2 x 2 pixels cannot be had without splitting pixels: black if either
      // pixel that it touches is, so that no hole arises that is not there.
      return counts_.count(static_cast<int>(column / 2), top, 2, 1) > 0 ? kBlack : kWhite;
    }
    const std::uint32_t black = counts_.count(static_cast<int>(column) * size / 2, top, size, size);
    const double all = static_cast<double>(size) * size;
    if (black == 0) return kWhite;
    if (black == all) return kBlack;
    if (depth == rules_.max_depth) return colour_of_mixed(black, all, rules_.black_fraction);
    std::array<const ColouredNode*, 6> parts;
    for (std::size_t part = 0; part < 6; ++part)
      parts[part] = build(depth + 1, 2 * column + part % 3, 2 * row + part / 3);
    std::array<const ColouredNode*, 8> children;
    for (std::size_t octant = 0; octant < 8; ++octant) children[octant] = parts[part_of_[octant]];
    return pool_.make(children);
  }

  const int side_;
  const BlackCounts counts_;
  const SilhouetteRules& rules_;
  NodePool& pool_;
  /// For each octant: left, centre, right of the upper row, then of the lower one.
  std::array<std::size_t, 8> part_of_{};
  std::vector<std::vector<const ColouredNode*>> known_;  ///< of inner depths; nullptr: not decided
};

}  // namespace

const ColouredNode* build_edge_tree(const View& view, const Mask& square,
                                    const SilhouetteRules& rules, NodePool& pool) {
  return EdgeTreeBuilder(view, square, rules, pool).build();
}

}  // namespace spoctree
