#include "server/silhouettes/coloured_node.hpp"

#include <algorithm>
#include <string>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {

const ColouredNode kWhiteLeaf;
const ColouredNode kBlackLeaf;

}  // namespace

const ColouredNode* const kWhite = &kWhiteLeaf;
const ColouredNode* const kBlack = &kBlackLeaf;

void NodeLimit::take(std::size_t nodes) {
  const auto count = static_cast<std::int64_t>(nodes);
  if ((left_ -= count) >= 0) return;
  left_ += count;
  throw BadInput("more than " + std::to_string(nodes_) + " " + what_);
}

const ColouredNode* NodePool::make(const std::array<const ColouredNode*, 8>& children) {
  const ColouredNode* const first = children[0];
  if (is_leaf(first) && std::all_of(children.begin(), children.end(),
                                    [first](const ColouredNode* node) { return node == first; }))
    return first;
  if (used_ == kBlock) {
    limit_.take(kBlock);
    blocks_.push_back(std::make_unique<ColouredNode[]>(kBlock));
    used_ = 0;
  }
  ColouredNode& node = blocks_.back()[used_++];
  node.children = children;
  return &node;
}

const ColouredNode* intersect(const ColouredNode* a, const ColouredNode* b, NodePool& pool) {
  if (a == b || b == kBlack || a == kWhite) return a;
  if (a == kBlack || b == kWhite) return b;
  std::array<const ColouredNode*, 8> children;
  bool is_a = true;
  for (std::size_t i = 0; i < 8; ++i) {
    children[i] = intersect(a->children[i], b->children[i], pool);
    is_a = is_a && children[i] == a->children[i];
  }
  return is_a ? a : pool.make(children);
}

}  // namespace spoctree
