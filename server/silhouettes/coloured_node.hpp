// Octrees of black and white while they are made: nodes that may be shared, so that the two octants
// that a quadrant stands for are one node.
//
// The product is an Octree (common/tree); these are the builder's working memory, as fragments are
// for solids.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
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

/// How many nodes there may be at a time, for all threads: silhouettes that are noise have trees
/// without end.
class NodeLimit {
 public:
  /// `what` completes "more than N ...".
  NodeLimit(std::int64_t nodes, const char* what) : nodes_(nodes), left_(nodes), what_(what) {}
  /// Throws BadInput when there are not so many left.
  void take(std::size_t nodes);
  void give_back(std::size_t nodes) { left_ += static_cast<std::int64_t>(nodes); }

 private:
  const std::int64_t nodes_;
  std::atomic<std::int64_t> left_;
  const char* what_;
};

/// Where nodes live; they go all at once.
class NodePool {
 public:
  /// REQUIRES: the limit outlives this.
  explicit NodePool(NodeLimit& limit) : limit_(limit) {}
  ~NodePool() { limit_.give_back(blocks_.size() * kBlock); }
  NodePool(const NodePool&) = delete;
  NodePool& operator=(const NodePool&) = delete;

  /// The node with these children; siblings of one colour are merged. Throws BadInput at the limit.
  const ColouredNode* make(const std::array<const ColouredNode*, 8>& children);

 private:
  static constexpr std::size_t kBlock = 1024;
  NodeLimit& limit_;
  std::vector<std::unique_ptr<ColouredNode[]>> blocks_;
  std::size_t used_ = kBlock;  ///< of the last block
};

/// What is black in both trees (section II-D). Parts that one of them does not change are shared
/// with the other, so both pools must live as long as the result. O(nodes that both have).
const ColouredNode* intersect(const ColouredNode* a, const ColouredNode* b, NodePool& pool);

}  // namespace spoctree
