#include "server/build/reach_boxes.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace spoctree {

namespace {

constexpr std::uint32_t kLeafSize = 8;

/// Doubles tell how far a box reaches to better than this. The doubt of any question is larger.
constexpr double kRounding = 0x1p-48;

}  // namespace

void ReachBoxes::prepare() {
  boxes_.clear();
  if (!points_.empty()) build(0, static_cast<std::uint32_t>(points_.size()));
}

std::uint32_t ReachBoxes::build(std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(boxes_.size());
  Vec3 lower = points_[begin].position;
  Vec3 upper = lower;
  for (std::uint32_t i = begin; i < end; ++i) {
    lower = glm::min(lower, points_[i].position);
    upper = glm::max(upper, points_[i].position);
  }
  const Vec3 half = 0.5 * (upper - lower);
  boxes_.push_back({0.5 * (lower + upper), half, begin, end, 0});
  if (end - begin <= kLeafSize) return index;
  const int axis = half.x >= half.y && half.x >= half.z ? 0 : (half.y >= half.z ? 1 : 2);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(
      points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
      [axis](const Point& a, const Point& b) { return a.position[axis] < b.position[axis]; });
  build(begin, middle);
  const std::uint32_t right = build(middle, end);
  boxes_[index].right = right;
  return index;
}

bool ReachBoxes::any_beyond(Vec3 normal, double offset, double doubt) const {
  if (boxes_.empty()) return false;
  const Vec3 reach = glm::abs(normal);
  // No point of a box is farther beyond the plane than this.
  const auto farthest = [&](const Box& box) {
    return glm::dot(normal, box.centre) + glm::dot(reach, box.half) - offset;
  };
  std::uint32_t stack[128];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Box& box = boxes_[index];
    if (farthest(box) < doubt - kRounding) continue;
    if (box.right == 0) {
      for (std::uint32_t i = box.begin; i < box.end; ++i) {
        const Point& point = points_[i];
        const double value = glm::dot(normal, point.position) - offset;
        if (value > doubt + 2 * point.error) return true;
      }
      continue;
    }
    const std::uint32_t left = index + 1;
    const bool left_first = farthest(boxes_[left]) >= farthest(boxes_[box.right]);
    stack[depth++] = left_first ? box.right : left;
    stack[depth++] = left_first ? left : box.right;
  }
  return false;
}

}  // namespace spoctree
