#include "server/solid/point_clusters.hpp"

#include <bit>
#include <glm/common.hpp>

#include "server/mesh/point_table.hpp"
#include "server/solid/face_groups.hpp"

namespace spoctree {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Cells in which points are looked for at first are so many times as wide as what is looked for:
// then few points are alone in their cell, but near its walls.
constexpr double kCoarseness = 0x1p20;

std::uint64_t mixed(std::uint64_t bits) {
  bits *= 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio, odd
  return bits ^ (bits >> 32);
}

}  // namespace

std::vector<std::uint32_t> equal_points(std::span<const Vec3> points) {
  std::vector<Vec3> different;
  PointTable table(different);
  std::vector<std::uint32_t> first_of;  // by number in the table
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const std::uint32_t number = table.find_or_add(points[i]);
    if (number == first_of.size()) first_of.push_back(i);
    first[i] = first_of[number];
  }
  return first;
}

std::vector<std::uint32_t> find_crowded_points(std::span<const Vec3> points, double distance) {
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t first = kNone;
  };
  std::vector<Slot> slots(std::bit_ceil(2 * points.size() + 2));
  const std::size_t mask = slots.size() - 1;
  const double side = kCoarseness * distance;
  std::vector<bool> is_crowded(points.size(), false);
  std::size_t count = 0;
  const auto mark = [&](std::uint32_t i) {
    if (!is_crowded[i]) ++count;
    is_crowded[i] = true;
  };
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = std::floor(points[i][axis] / side);
      const double within = points[i][axis] - cell * side;
      if (within <= distance || within >= side - distance) mark(i);
      key = mixed(key + static_cast<std::uint64_t>(static_cast<std::int64_t>(cell)));
    }
    std::size_t slot = key & mask;
    while (slots[slot].first != kNone && slots[slot].key != key) slot = (slot + 1) & mask;
    if (slots[slot].first == kNone) {
      slots[slot] = {key, i};
    } else {
      mark(slots[slot].first);
      mark(i);
    }
  }
  std::vector<std::uint32_t> crowded;
  crowded.reserve(count);
  for (std::uint32_t i = 0; i < points.size() && count > 0; ++i) {
    if (is_crowded[i]) crowded.push_back(i);
  }
  return crowded;
}

PointCells::PointCells(std::span<const Vec3> points, double side) : side_(side) {
  entries_.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) entries_.push_back({cell_of(points[i]), i});
  std::sort(entries_.begin(), entries_.end());
}

PointCells::Cell PointCells::cell_of(Vec3 p) const {
  // Points beyond this are all in one cell: nobody looks for what is so much smaller than they.
  constexpr double kMost = 0x1p62;
  Cell cell{};
  for (int axis = 0; axis < 3; ++axis) {
    cell[static_cast<std::size_t>(axis)] =
        static_cast<std::int64_t>(std::clamp(std::floor(p[axis] / side_), -kMost, kMost));
  }
  return cell;
}

std::vector<std::uint32_t> bounded_clusters(std::vector<Box> boxes,
                                            std::span<const PointPair> pairs, double width,
                                            std::span<const PointPair> sure) {
  FaceGroups wide(boxes.size());
  for (const auto& [i, j] : pairs) wide.join(i, j);
  for (const auto& [i, j] : sure) wide.join(i, j);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    Box& all = boxes[wide.group_of(i)];
    all.lower = glm::min(all.lower, boxes[i].lower);
    all.upper = glm::max(all.upper, boxes[i].upper);
  }
  FaceGroups narrow(boxes.size());
  for (const auto& [i, j] : sure) narrow.join(i, j);
  std::vector<std::uint32_t> cluster(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const std::uint32_t group = wide.group_of(i);
    const Vec3 size = boxes[group].upper - boxes[group].lower;
    const bool is_bounded = size.x <= width && size.y <= width && size.z <= width;
    cluster[i] = is_bounded ? group : narrow.group_of(i);
  }
  return cluster;
}

}  // namespace spoctree
