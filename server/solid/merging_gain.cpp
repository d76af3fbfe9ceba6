#include "server/solid/merging_gain.hpp"

#include <algorithm>
#include <utility>

#include "server/solid/face_groups.hpp"

namespace spoctree {

namespace {

constexpr std::uint32_t kStays = kNone - 1;

/// Joins all that have the same key, but for the keys that stand for nothing.
class JoinedByKey {
 public:
  JoinedByKey(FaceGroups& parts, std::size_t keys) : parts_(parts), first_(keys, kNone) {}
  void leave_out(std::uint32_t key) { first_[key] = kStays; }
  bool is_left_out(std::uint32_t key) const { return first_[key] == kStays; }
  void join(std::uint32_t key, std::uint32_t triangle) {
    if (is_left_out(key)) return;
    if (first_[key] == kNone) first_[key] = triangle;
    parts_.join(first_[key], triangle);
  }

 private:
  FaceGroups& parts_;
  std::vector<std::uint32_t> first_;
};

}  // namespace

MergingGain::MergingGain(const FlatSurface& surface, FlatGroups before)
    : surface_(surface), before_(std::move(before)), planes_(surface.planes) {
  for (const FlatGroup& group : before_.groups) {
    for (const std::uint32_t t : group.triangles) planes_[t] = group.plane;
  }
  NumberedPlanes numbered = number_planes(planes_);
  plane_numbers_ = std::move(numbered.number_of);
  distinct_planes_ = numbered.first.size();
}

bool MergingGain::is_plane_changed(const FlatGroups& now, std::uint32_t triangle) const {
  const std::uint32_t group = now.of_triangle[triangle];
  return planes_[triangle] !=
         (group == kNone ? surface_.planes[triangle] : now.groups[group].plane);
}

std::vector<std::uint32_t> MergingGain::find_wasted(const FlatGroups& now,
                                                    std::span<const GridPoint> points) const {
  const auto count = static_cast<std::uint32_t>(surface_.triangles.size());
  const auto is_moved = [&](std::uint32_t v) { return points[v] != surface_.points[v]; };
  std::vector<std::uint32_t> changed;
  FaceGroups parts(count);
  JoinedByKey by_plane(parts, distinct_planes_);
  JoinedByKey by_group(parts, now.groups.size());
  JoinedByKey by_corner(parts, points.size());
  for (std::uint32_t t = 0; t < count; ++t) {
    const Corners& corners = surface_.triangles[t];
    if (is_plane_changed(now, t) || std::any_of(corners.begin(), corners.end(), is_moved)) {
      changed.push_back(t);
      continue;
    }
    // These planes are there before and after.
    by_plane.leave_out(plane_numbers_[t]);
    if (now.of_triangle[t] != kNone) by_group.leave_out(now.of_triangle[t]);
  }
  for (const std::uint32_t t : changed) {
    by_plane.join(plane_numbers_[t], t);
    if (now.of_triangle[t] != kNone) by_group.join(now.of_triangle[t], t);
    for (const std::uint32_t v : surface_.triangles[t]) {
      if (is_moved(v)) by_corner.join(v, t);
    }
  }

  // A plane or group is of one part only, but for those that were left out.
  std::vector<std::uint32_t> lost(count, 0);
  std::vector<std::uint32_t> made(count, 0);
  std::vector<std::uint32_t> kept_of(count, 0);  // how many planes that are there after, too
  std::vector<bool> is_counted(distinct_planes_, false);
  std::vector<bool> is_group_counted(now.groups.size(), false);
  std::vector<std::uint64_t> kept;  // parts with planes
  for (const std::uint32_t t : changed) {
    const std::uint32_t part = parts.group_of(t);
    const std::uint32_t plane = plane_numbers_[t];
    if (by_plane.is_left_out(plane)) {
      kept.push_back(std::uint64_t{part} << 32 | plane);
    } else if (!is_counted[plane]) {
      is_counted[plane] = true;
      ++lost[part];
    }
    const std::uint32_t group = now.of_triangle[t];
    if (group == kNone) {
      ++made[part];
    } else if (!by_group.is_left_out(group) && !is_group_counted[group]) {
      is_group_counted[group] = true;
      ++made[part];
    }
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  for (const std::uint64_t pair : kept) ++kept_of[pair >> 32];

  std::erase_if(changed, [&](std::uint32_t t) {
    const std::uint32_t part = parts.group_of(t);
    return kLeastGain * lost[part] >= kLeastGain * made[part] + lost[part] + kept_of[part];
  });
  return changed;
}

FlatGroups find_groups_in_planes(const FlatSurface& surface) {
  FlatGroups groups = find_flat_groups(surface, static_cast<double>(kGridFlatness));
  for (FlatGroup& group : groups.groups) {
    if (group.is_flat) continue;
    for (const std::uint32_t t : group.triangles) groups.of_triangle[t] = kNone;
    group.triangles.clear();
  }
  return groups;
}

}  // namespace spoctree
