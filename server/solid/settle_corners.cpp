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

bool is_on(const GridPlane& plane, const GridPoint& point) {
  constexpr Int128 kMost = Int128{1} << (2 * kGridBits - 49);
  static_assert(kGridFlatness == 0x1p-49L);
  const Int128 height = height_above(plane, point);
  return -kMost <= height && height <= kMost;
}

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
      is_touched_(surface.points.size(), 0) {
  for (const FlatGroup& group : groups_.groups) {
    if (group.is_exact && !group.is_loose) continue;
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

void CornerSettler::regroup(const std::vector<std::uint32_t>& triangles, std::uint32_t group) {
  std::vector<std::uint32_t> left;
  for (const std::uint32_t t : triangles) {
    left.push_back(groups_.of_triangle[t]);
    groups_.of_triangle[t] = group;
    groups_.groups[group].triangles.push_back(t);
    touch_corners(t);
  }
  std::sort(left.begin(), left.end());
  left.erase(std::unique(left.begin(), left.end()), left.end());
  for (const std::uint32_t g : left) {
    for (const std::uint32_t t : drop_strangers(groups_, g)) touch_corners(t);
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
