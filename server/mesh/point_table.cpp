#include "server/mesh/point_table.hpp"

#include <bit>
#include <cstddef>
#include <limits>

namespace spoctree {

namespace {

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();

// Coordinates on a grid differ in a few middle bits only. A multiplication carries them to the
// high half of the word, and the xor brings them back down to where the slot number is taken.
std::uint64_t mixed(std::uint64_t bits) {
  bits *= 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio, odd
  return bits ^ (bits >> 32);
}

std::size_t hash(const glm::dvec3& point) {
  std::uint64_t h = mixed(std::bit_cast<std::uint64_t>(point.x));
  h = mixed(h + std::bit_cast<std::uint64_t>(point.y));
  return mixed(h + std::bit_cast<std::uint64_t>(point.z));
}

}  // namespace

PointTable::PointTable(std::vector<glm::dvec3>& points) : points_(points), slots_(64, kFree) {}

std::uint32_t PointTable::find_or_add(glm::dvec3 point) {
  point += 0.0;  // -0.0 + 0.0 is 0.0, every other number stays as it is
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(point) & mask;
  while (slots_[slot] != kFree) {
    if (points_[slots_[slot]] == point) return slots_[slot];
    slot = (slot + 1) & mask;
  }
  const auto number = static_cast<std::uint32_t>(points_.size());
  slots_[slot] = number;
  points_.push_back(point);
  if (2 * points_.size() > slots_.size()) grow();
  return number;
}

void PointTable::grow() {
  slots_.assign(2 * slots_.size(), kFree);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t number = 0; number < points_.size(); ++number) {
    std::size_t slot = hash(points_[number]) & mask;
    while (slots_[slot] != kFree) slot = (slot + 1) & mask;
    slots_[slot] = static_cast<std::uint32_t>(number);
  }
}

}  // namespace spoctree
