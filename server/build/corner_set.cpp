#include "server/build/corner_set.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace spoctree {

namespace {
constexpr std::uint32_t kLeafSize = 12;
constexpr std::uint32_t kLinearSize = 48;
}  // namespace

void CornerSet::clear() {
  items_.clear();
  boxes_.clear();
  last_hit_ = 0;
}

void CornerSet::prepare() {
  boxes_.clear();
  if (items_.size() > kLinearSize) build(0, static_cast<std::uint32_t>(items_.size()));
}

std::uint32_t CornerSet::build(std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(boxes_.size());
  Vec3 lower = items_[begin].corner->position;
  Vec3 upper = lower;
  double error = 0;
  for (std::uint32_t i = begin; i < end; ++i) {
    lower = glm::min(lower, items_[i].corner->position);
    upper = glm::max(upper, items_[i].corner->position);
    error = std::max(error, items_[i].corner->error);
  }
  boxes_.push_back({0.5 * (lower + upper), 0.5 * (upper - lower), error, begin, end, 0});
  if (end - begin <= kLeafSize) return index;
  const Vec3 half = boxes_[index].half;
  const int axis = half.x >= half.y && half.x >= half.z ? 0 : (half.y >= half.z ? 1 : 2);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                   [axis](const Item& a, const Item& b) {
                     return a.corner->position[axis] < b.corner->position[axis];
                   });
  build(begin, middle);
  const std::uint32_t right = build(middle, end);
  boxes_[index].right = right;
  return index;
}

bool CornerSet::any_on_side(std::uint32_t plane, int sign, const Plane& coefficients,
                            const CornerSides& sides) {
  const auto any_of = [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      if (sides.side(*items_[i].corner, items_[i].triangle, plane) == sign) {
        last_hit_ = i;
        return true;
      }
    }
    return false;
  };
  if (items_.empty()) return false;
  if (any_of(last_hit_, last_hit_ + 1)) return true;
  if (boxes_.empty()) return any_of(0, static_cast<std::uint32_t>(items_.size()));
  const Vec3 normal = coefficients.normal * static_cast<double>(sign);
  const double offset = coefficients.offset * sign;
  const Vec3 reach = glm::abs(normal);
  // No corner of a box is farther on the wanted side than this, up to rounding.
  const auto farthest = [&](const Box& box) {
    return glm::dot(normal, box.centre) + glm::dot(reach, box.half) - offset + 2 * box.error;
  };
  std::uint32_t stack[128];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Box& box = boxes_[index];
    if (farthest(box) < -0x1p-46) continue;
    if (box.right == 0) {
      if (any_of(box.begin, box.end)) return true;
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
