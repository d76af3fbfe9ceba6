#include "server/solid/settle_corners.hpp"

#include <algorithm>
#include <utility>

#include "server/solid/fit_plane.hpp"
#include "server/solid/settle_corner.hpp"

namespace spoctree {

namespace {

// After so many rounds groups in conflict are given up as a whole.
constexpr int kMostRounds = 40;

CornerPlane seen_from(const GridPlane& plane, const GridPoint& corner) {
  CornerPlane seen;
  for (std::size_t i = 0; i < 3; ++i) {
    seen.normal[i] = static_cast<long double>(plane.normal[i]) * 0x1p-52L;
  }
  const Int128 height = (static_cast<Int128>(plane.offset) << kGridBits) - plane.height(corner);
  seen.height = static_cast<long double>(height) * 0x1p-104L;
  return seen;
}

}  // namespace

CornerSettler::CornerSettler(const FlatSurface& surface, FlatGroups groups, double most_move)
    : surface_(surface),
      groups_(std::move(groups)),
      most_move_(most_move),
      points_(surface.points),
      triangle_at_(surface.points.size(), kNone),
      is_pinned_(surface.points.size(), 0),
      is_touched_(surface.points.size(), 0) {
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (const std::uint32_t v : surface.triangles[t]) triangle_at_[v] = t;
  }
  for (const FlatGroup& group : groups_.groups) {
    if (group.is_exact) continue;
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

void CornerSettler::settle(std::uint32_t vertex, std::vector<Conflict>& conflicts) {
  around_.clear();
  visit_fan(surface_.triangles, surface_.neighbours, triangle_at_[vertex], vertex,
            [&](std::uint32_t t) {
              const std::uint32_t group = groups_.of_triangle[t];
              if (group != kNone && (around_.empty() || around_.back() != group)) {
                around_.push_back(group);
              }
            });
  std::sort(around_.begin(), around_.end(), [&](std::uint32_t g, std::uint32_t h) {
    const double area_g = groups_.groups[g].area;
    const double area_h = groups_.groups[h].area;
    return area_g != area_h ? area_g > area_h : g < h;
  });
  around_.erase(std::unique(around_.begin(), around_.end()), around_.end());

  const GridPoint& corner = surface_.points[vertex];
  points_[vertex] = corner;
  std::vector<CornerPlane> planes;
  planes.reserve(around_.size());
  bool is_there = true;
  for (const std::uint32_t group : around_) {
    planes.push_back(seen_from(groups_.groups[group].plane, corner));
    planes.back().is_reached = std::abs(planes.back().height) <= kGridFlatness;
    is_there = is_there && planes.back().is_reached;
  }
  if (!is_there && is_pinned_[vertex] == 0) {
    const auto way = settle_corner(planes, static_cast<long double>(most_move_));
    for (std::size_t i = 0; i < 3; ++i) points_[vertex][i] += std::llrint(way[i] * 0x1p52L);
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!planes[i].is_reached) conflicts.push_back({vertex, around_[i]});
  }
}

void CornerSettler::release(std::uint32_t triangle) {
  groups_.of_triangle[triangle] = kNone;
  touch_corners(triangle);
}

void CornerSettler::fit_again(std::uint32_t number) {
  FlatGroup& group = groups_.groups[number];
  std::erase_if(group.triangles, [&](std::uint32_t t) { return groups_.of_triangle[t] != number; });
  if (group.triangles.size() < 2) {
    for (const std::uint32_t t : group.triangles) release(t);
    group.triangles.clear();
    return;
  }
  const FittedPlane fitted = fit_plane(surface_, group.triangles);
  group.is_exact = fitted.is_exact;
  if (fitted.plane == group.plane) return;
  group.plane = fitted.plane;
  for (const std::uint32_t t : group.triangles) touch_corners(t);
}

void CornerSettler::settle() {
  std::vector<Conflict> conflicts;
  std::vector<std::uint32_t> changed;
  for (int round = 0; !touched_.empty(); ++round) {
    conflicts.clear();
    std::sort(touched_.begin(), touched_.end());
    for (const std::uint32_t v : touched_) {
      is_touched_[v] = 0;
      settle(v, conflicts);
    }
    touched_.clear();

    changed.clear();
    for (const auto& [vertex, group] : conflicts) {
      changed.push_back(group);
      if (round >= kMostRounds) {
        for (const std::uint32_t t : groups_.groups[group].triangles) release(t);
        continue;
      }
      visit_fan(surface_.triangles, surface_.neighbours, triangle_at_[vertex], vertex,
                [&, g = group](std::uint32_t t) {
                  if (groups_.of_triangle[t] == g) release(t);
                });
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const std::uint32_t group : changed) fit_again(group);
  }
}

}  // namespace spoctree
