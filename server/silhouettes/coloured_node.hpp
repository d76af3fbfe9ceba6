// Octrees of black and white while they are made: nodes that may be shared, so that the two octants
// that a quadrant stands for are one node.
//
// The product is an Octree (common/tree); these are the builder's working memory, as fragments are
// for solids.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace spoctree {

/// A node: kWhite, kBlack, or one with eight children, x + 2y + 4z, that are not all black and not
/// all white.
struct ColouredNode {
  std::array<const ColouredNode*, 8> children{};
};

extern const ColouredNode* const kWhite;
extern const ColouredNode* const kBlack;

inline bool is_leaf(const ColouredNode* node) { return node == kWhite || node == kBlack; }

/// The part of a node's cube that is octant `octant`: a leaf is all of one colour.
inline const ColouredNode* child_of(const ColouredNode* node, int octant) {
  return is_leaf(node) ? node : node->children[static_cast<std::size_t>(octant)];
}

/// Where nodes live; they go all at once.
class NodePool {
 public:
  /// The node with these children; siblings of one colour are merged.
  const ColouredNode* make(const std::array<const ColouredNode*, 8>& children);

 private:
  static constexpr std::size_t kBlock = 4096;
  std::vector<std::unique_ptr<ColouredNode[]>> blocks_;
  std::size_t used_ = kBlock;  ///< of the last block
};

/// What is black in both trees (section II-D). Parts that one of them does not change are shared
/// with the other, so both pools must live as long as the result. O(nodes that both have).
const ColouredNode* intersect(const ColouredNode* a, const ColouredNode* b, NodePool& pool);

}  // namespace spoctree
