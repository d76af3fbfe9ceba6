#include "server/solid/box_tree.hpp"

#include <glm/common.hpp>

#include "common/base/parallel.hpp"

namespace spoctree {

namespace {

constexpr std::uint32_t kBoxesPerLeaf = 4;

// Smaller nodes are built by one thread.
constexpr std::uint32_t kWorthASplit = 4096;

// The numbers of nodes of trees of `boxes` boxes and of one box more.
std::array<std::uint32_t, 2> node_counts(std::uint32_t boxes) {
  if (boxes < kBoxesPerLeaf) return {1, 1};
  if (boxes == kBoxesPerLeaf) return {1, 3};
  const auto [half, half_and_one] = node_counts(boxes / 2);
  if (boxes % 2 == 0) return {1 + 2 * half, 1 + half + half_and_one};
  return {1 + half + half_and_one, 1 + 2 * half_and_one};
}

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) {
  leaves_.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) leaves_.push_back({boxes[i], i});
  if (boxes.empty()) return;
  const auto count = static_cast<std::uint32_t>(boxes.size());
  nodes_.resize(node_counts(count)[0]);
  build(0, 0, count);
}

void BoxTree::build(std::uint32_t self, std::uint32_t begin, std::uint32_t end) {
  Box box = leaves_[begin].box;
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    box.lower = glm::min(box.lower, leaves_[i].box.lower);
    box.upper = glm::max(box.upper, leaves_[i].box.upper);
  }
  nodes_[self] = {box, begin, end, 0};
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
  const std::uint32_t second = self + 1 + node_counts(middle - begin)[0];
  nodes_[self].second_child = second;
  if (end - begin < kWorthASplit) {
    build(self + 1, begin, middle);
    build(second, middle, end);
  } else {
    parallel_invoke([&] { build(self + 1, begin, middle); }, [&] { build(second, middle, end); });
  }
}

std::vector<NodePair> BoxTree::split_pairs(std::uint32_t most) const {
  std::vector<NodePair> whole;
  std::vector<NodePair> waiting;
  if (!nodes_.empty()) waiting.push_back({0, 0});
  while (!waiting.empty()) {
    const NodePair pair = waiting.back();
    waiting.pop_back();
    if (!nodes_[pair[0]].box.overlaps(nodes_[pair[1]].box)) continue;
    if (std::max(size_of(pair[0]), size_of(pair[1])) > most && can_be_split(pair)) {
      visit_halves(pair, [&](NodePair halves) { waiting.push_back(halves); });
    } else {
      whole.push_back(pair);
    }
  }
  return whole;
}

std::vector<std::uint32_t> BoxTree::common_labels(
    std::span<const std::uint32_t> label_of_box) const {
  std::vector<std::uint32_t> labels(nodes_.size());
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    const Node& node = nodes_[n];
    labels[n] = label_of_box[leaves_[node.begin].index];
    if (node.second_child != 0) {
      if (labels[n + 1] != labels[node.second_child]) labels[n] = kMixed;
      if (labels[n + 1] == kMixed) labels[n] = kMixed;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (label_of_box[leaves_[i].index] != labels[n]) labels[n] = kMixed;
    }
  }
  return labels;
}

Box box_around(Vec3 a, Vec3 b, Vec3 c) {
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

}  // namespace spoctree
