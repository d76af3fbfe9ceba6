#include "server/solid/settle_corners.hpp"

#include <algorithm>
#include <utility>

#include "server/solid/settle_corner.hpp"

namespace spoctree {

namespace {

// Of a plane above a point, in units of 2^-104.
Int128 height_above(const GridPlane& plane, const GridPoint& point) {
  return (static_cast<Int128>(plane.offset) << kGridBits) - plane.height(point);
}

// Closer to a plane than this (in units of 2^-104), a triangle beside it counts as in it. It is
// about what rebuilding can still tell apart.
constexpr Int128 kNearlyOn = Int128{1} << (2 * kGridBits - 33);

CornerPlane seen_from(const GridPlane& plane, const GridPoint& corner) {
  CornerPlane seen;
  for (std::size_t i = 0; i < 3; ++i) {
    seen.normal[i] = static_cast<long double>(plane.normal[i]) * 0x1p-52L;
  }
  seen.height = static_cast<long double>(height_above(plane, corner)) * 0x1p-104L;
  return seen;
}

template <class Number>
GridPoint moved(GridPoint point, const std::array<Number, 3>& way) {
  for (std::size_t i = 0; i < 3; ++i) point[i] += std::llrint(way[i] * Number{0x1p52});
  return point;
}

}  // namespace

CornerSettler::CornerSettler(const FlatSurface& surface, FlatGroups groups, JointFit fit,
                             double most_move)
    : surface_(surface),
      groups_(std::move(groups)),
      fit_(std::move(fit)),
      most_move_(most_move),
      points_(surface.points),
      is_pinned_(surface.points.size(), 0),
      is_touched_(surface.points.size(), 0),
      is_adopted_(surface.triangles.size(), 0) {
  for (const FlatGroup& group : groups_.groups) {
    if (!group.may_move()) continue;
    for (const std::uint32_t t : group.triangles) touch_corners(t);
  }
}

void CornerSettler::touch(std::uint32_t vertex) {
  if (std::exchange(is_touched_[vertex], 1) == 0) touched_.push_back(vertex);
}

void CornerSettler::touch_corners(std::uint32_t triangle) {
  for (const std::uint32_t v : surface_.triangles[triangle]) touch(v);
}

void CornerSettler::pin(std::uint32_t vertex) {
  is_pinned_[vertex] = 1;
  touch(vertex);
}

/// Whatever they are in.
void CornerSettler::leave_groups(const std::vector<std::uint32_t>& triangles) {
  std::vector<std::uint32_t> left;
  for (const std::uint32_t t : triangles) {
    const std::uint32_t group = std::exchange(groups_.of_triangle[t], kNone);
    if (group != kNone) left.push_back(group);
    touch_corners(t);
  }
  std::sort(left.begin(), left.end());
  left.erase(std::unique(left.begin(), left.end()), left.end());
  for (const std::uint32_t g : left) {
    for (const std::uint32_t t : drop_strangers(groups_, g)) touch_corners(t);
  }
}

void CornerSettler::regroup(const std::vector<std::uint32_t>& triangles, std::uint32_t group) {
  leave_groups(triangles);
  for (const std::uint32_t t : triangles) {
    groups_.of_triangle[t] = group;
    groups_.groups[group].triangles.push_back(t);
  }
}

void CornerSettler::give_back(const std::vector<std::uint32_t>& triangles,
                              const FlatGroups& before) {
  leave_groups(triangles);
  std::vector<std::uint32_t> new_number(before.groups.size(), kNone);
  for (const std::uint32_t t : triangles) {
    if (before.of_triangle[t] == kNone) continue;
    const FlatGroup& old_group = before.groups[before.of_triangle[t]];
    std::uint32_t& number = new_number[before.of_triangle[t]];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(groups_.groups.size());
      groups_.groups.push_back(old_group);
      groups_.groups.back().triangles.clear();
    }
    groups_.of_triangle[t] = number;
    groups_.groups[number].triangles.push_back(t);
  }
}

bool CornerSettler::is_on_all_planes(const GridPoint& point) const {
  return std::all_of(around_.begin(), around_.end(), [&](std::uint32_t group) {
    return is_on(groups_.groups[group].plane, point);
  });
}

bool CornerSettler::follow_joint_fit(std::uint32_t vertex) {
  const auto& way = fit_.ways[vertex];
  if (!(way[0] * way[0] + way[1] * way[1] + way[2] * way[2] < most_move_ * most_move_)) {
    return false;
  }
  const GridPoint point = moved(surface_.points[vertex], way);
  if (!is_on_all_planes(point)) return false;
  points_[vertex] = point;
  return true;
}

void CornerSettler::settle(std::uint32_t vertex, std::vector<CornerConflict>& conflicts) {
  collect_groups_around(surface_, groups_, vertex, around_);
  std::sort(around_.begin(), around_.end(), [&](std::uint32_t g, std::uint32_t h) {
    const double area_g = groups_.groups[g].area;
    const double area_h = groups_.groups[h].area;
    return area_g != area_h ? area_g > area_h : g < h;
  });
  const GridPoint& corner = surface_.points[vertex];
  points_[vertex] = corner;
  if (is_on_all_planes(corner)) return;
  if (is_pinned_[vertex] != 0) {
    for (const std::uint32_t group : around_) {
      if (!is_on(groups_.groups[group].plane, corner)) conflicts.push_back({vertex, group});
    }
    return;
  }
  if (follow_joint_fit(vertex)) return;
  std::vector<CornerPlane> planes;
  planes.reserve(around_.size());
  for (const std::uint32_t group : around_) {
    planes.push_back(seen_from(groups_.groups[group].plane, corner));
  }
  points_[vertex] = moved(corner, settle_corner(planes, static_cast<long double>(most_move_)));
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!planes[i].is_reached) conflicts.push_back({vertex, around_[i]});
  }
}

void CornerSettler::settle() {
  do {
    settle_touched();
  } while (adopt());
}

bool CornerSettler::is_nearly_on(const GridPlane& plane, std::uint32_t triangle) const {
  const Corners& corners = surface_.triangles[triangle];
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
    const Int128 height = height_above(plane, points_[v]);
    return -kNearlyOn <= height && height <= kNearlyOn;
  });
}

// Triangles of which all corners were moved onto the plane of a group beside them, and groups of
// which all corners were: they would make faces at angles of nearly 180 degrees. Each triangle is
// adopted once at most.
bool CornerSettler::adopt() {
  bool has_adopted = false;
  std::vector<std::uint32_t> adopted;
  for (std::uint32_t g = 0; g < groups_.groups.size(); ++g) {
    if (!groups_.groups[g].may_move()) continue;
    // The list grows while it is walked: by neighbours of what has been adopted, too.
    for (std::size_t i = 0; i < groups_.groups[g].triangles.size(); ++i) {
      for (const std::uint32_t n : surface_.neighbours[groups_.groups[g].triangles[i]]) {
        const std::uint32_t h = groups_.of_triangle[n];
        const FlatGroup& group = groups_.groups[g];
        if (h == g || is_adopted_[n] != 0 || !is_nearly_on(group.plane, n)) continue;
        adopted.assign(1, n);
        if (h != kNone) {
          const FlatGroup& other = groups_.groups[h];
          if (other.area > group.area || (other.area == group.area && h < g)) continue;
          adopted = other.triangles;
          if (!std::all_of(adopted.begin(), adopted.end(), [&](std::uint32_t t) {
                return is_adopted_[t] == 0 && is_nearly_on(group.plane, t);
              })) {
            continue;
          }
        }
        for (const std::uint32_t t : adopted) is_adopted_[t] = 1;
        regroup(adopted, g);
        has_adopted = true;
      }
    }
  }
  return has_adopted;
}

void CornerSettler::settle_touched() {
  std::vector<CornerConflict> conflicts;
  while (!touched_.empty()) {
    conflicts.clear();
    std::sort(touched_.begin(), touched_.end());
    for (const std::uint32_t v : touched_) {
      is_touched_[v] = 0;
      settle(v, conflicts);
    }
    touched_.clear();
    for (const std::uint32_t t : release(surface_, groups_, conflicts)) touch_corners(t);
  }
}

}  // namespace spoctree
