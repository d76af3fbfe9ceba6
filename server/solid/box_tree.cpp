#include "server/solid/box_tree.hpp"

#include <glm/common.hpp>

namespace spoctree {

namespace {

constexpr std::uint32_t kBoxesPerLeaf = 4;

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) {
  leaves_.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) leaves_.push_back({boxes[i], i});
  nodes_.reserve(boxes.size());
  if (!boxes.empty()) build(0, static_cast<std::uint32_t>(boxes.size()));
}

void BoxTree::build(std::uint32_t begin, std::uint32_t end) {
  const std::size_t self = nodes_.size();
  Box box = leaves_[begin].box;
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    box.lower = glm::min(box.lower, leaves_[i].box.lower);
    box.upper = glm::max(box.upper, leaves_[i].box.upper);
  }
  nodes_.push_back({box, begin, end, 0});
  if (end - begin <= kBoxesPerLeaf) return;
  const Vec3 size = box.upper - box.lower;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(leaves_.begin() + begin, leaves_.begin() + middle, leaves_.begin() + end,
                   [axis](const Leaf& p, const Leaf& q) {
                     const double at_p = p.box.lower[axis] + p.box.upper[axis];
                     const double at_q = q.box.lower[axis] + q.box.upper[axis];
                     return at_p != at_q ? at_p < at_q : p.index < q.index;
                   });
  build(begin, middle);
  nodes_[self].second_child = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

Box box_around(Vec3 a, Vec3 b, Vec3 c) {
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

}  // namespace spoctree
