#include "server/solid/flat_groups.hpp"

#include <algorithm>
#include <utility>

#include "server/solid/fit_plane.hpp"
#include "server/solid/grow_patches.hpp"
#include "server/solid/join_rounded.hpp"
#include "server/solid/share_planes.hpp"

namespace spoctree {

namespace {

HeightRange heights(const FlatSurface& surface, const GridPlane& plane, std::uint32_t t) {
  HeightRange range;
  for (const std::uint32_t v : surface.triangles[t]) range.add(plane.height(surface.points[v]));
  return range;
}

// Adds what has a plane that is not its own: to an exact patch in it, or to each other.
void gather_equal_planes(const FlatSurface& surface, std::vector<PlanarPatch>& patches) {
  std::vector<bool> is_taken(surface.triangles.size(), false);
  std::vector<std::uint32_t> patch_of_plane(surface.distinct_planes, kNone);
  std::vector<std::uint32_t> alone_in_plane(surface.distinct_planes, kNone);
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    for (const std::uint32_t t : patches[p].triangles) is_taken[t] = true;
    std::uint32_t& first = patch_of_plane[surface.plane_numbers[patches[p].triangles.front()]];
    if (patches[p].is_exact && first == kNone) first = p;
  }
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    if (is_taken[t]) continue;
    std::uint32_t& patch = patch_of_plane[surface.plane_numbers[t]];
    std::uint32_t& alone = alone_in_plane[surface.plane_numbers[t]];
    if (patch == kNone && alone == kNone) {
      alone = t;
      continue;
    }
    if (patch == kNone) {
      patch = static_cast<std::uint32_t>(patches.size());
      patches.push_back({surface.planes[t],
                         heights(surface, surface.planes[t], alone),
                         true,
                         surface.areas[alone],
                         {alone}});
    }
    patches[patch].range.add(heights(surface, surface.planes[t], t));
    patches[patch].area += surface.areas[t];
    patches[patch].triangles.push_back(t);
  }
}

FlatGroups group_patches(std::vector<PlanarPatch> patches, const FlatSurface& surface,
                         double tolerance) {
  gather_equal_planes(surface, patches);
  const std::vector<std::uint32_t> number_of = share_planes(patches, surface, tolerance);
  FlatGroups found;
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    if (number_of[p] >= found.groups.size()) found.groups.resize(number_of[p] + 1);
    std::vector<std::uint32_t>& all = found.groups[number_of[p]].triangles;
    all.insert(all.end(), patches[p].triangles.begin(), patches[p].triangles.end());
  }
  found.of_triangle.assign(surface.triangles.size(), kNone);
  for (std::uint32_t g = 0; g < found.groups.size(); ++g) {
    fit_again(surface, found.groups[g]);
    for (const std::uint32_t t : found.groups[g].triangles) found.of_triangle[t] = g;
  }
  return found;
}

}  // namespace

FlatGroups find_flat_groups(const FlatSurface& surface, double tolerance) {
  return group_patches(grow_patches(surface, tolerance), surface, tolerance);
}

FlatAndRoundedGroups find_flat_and_rounded_groups(const FlatSurface& surface,
                                                  const FlatTolerance& tolerance) {
  FlatAndRoundedGroups found;
  std::vector<PlanarPatch> patches = grow_patches(surface, tolerance.spread);
  if (tolerance.has_rounding()) {
    std::vector<PlanarPatch> joined = patches;
    if (join_rounded(joined, surface, tolerance)) {
      found.rounded = group_patches(std::move(joined), surface, tolerance.spread);
    }
  }
  found.flat = group_patches(std::move(patches), surface, tolerance.spread);
  return found;
}

std::size_t count_planes(const FlatGroups& groups) {
  const auto is_used = [](const FlatGroup& group) { return !group.triangles.empty(); };
  const auto used = std::count_if(groups.groups.begin(), groups.groups.end(), is_used);
  const auto alone = std::count(groups.of_triangle.begin(), groups.of_triangle.end(), kNone);
  return static_cast<std::size_t>(used + alone);
}

void collect_groups_around(const FlatSurface& surface, const FlatGroups& groups,
                           std::uint32_t vertex, std::vector<std::uint32_t>& groups_around) {
  groups_around.clear();
  visit_fan(surface.triangles, surface.neighbours, surface.triangle_at[vertex], vertex,
            [&](std::uint32_t t) {
              const std::uint32_t group = groups.of_triangle[t];
              if (group == kNone) return;
              if (groups_around.empty() || groups_around.back() != group) {
                groups_around.push_back(group);
              }
            });
  std::sort(groups_around.begin(), groups_around.end());
  groups_around.erase(std::unique(groups_around.begin(), groups_around.end()), groups_around.end());
}

void fit_again(const FlatSurface& surface, FlatGroup& group) {
  const FittedPlane fitted = fit_plane(surface, group.triangles);
  group.plane = fitted.plane;
  group.area = fitted.area;
  group.is_exact = fitted.is_exact;
  group.is_flat =
      fitted.is_exact ||
      std::all_of(group.triangles.begin(), group.triangles.end(), [&](std::uint32_t t) {
        const Corners& corners = surface.triangles[t];
        return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
          return is_on(fitted.plane, surface.points[v]);
        });
      });
}

std::vector<std::uint32_t> release(const FlatSurface& surface, FlatGroups& groups,
                                   std::span<const CornerConflict> conflicts) {
  std::vector<std::uint32_t> released;
  std::vector<std::uint32_t> changed;
  std::vector<std::uint32_t> left;  // the groups that one corner cannot lie on
  for (std::size_t i = 0; i < conflicts.size();) {
    const std::uint32_t vertex = conflicts[i].vertex;
    left.clear();
    for (; i < conflicts.size() && conflicts[i].vertex == vertex; ++i) {
      left.push_back(conflicts[i].group);
    }
    std::sort(left.begin(), left.end());
    visit_fan(surface.triangles, surface.neighbours, surface.triangle_at[vertex], vertex,
              [&](std::uint32_t t) {
                if (!std::binary_search(left.begin(), left.end(), groups.of_triangle[t])) return;
                groups.of_triangle[t] = kNone;
                released.push_back(t);
              });
    changed.insert(changed.end(), left.begin(), left.end());
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  for (const std::uint32_t number : changed) {
    const std::vector<std::uint32_t> last = drop_strangers(groups, number);
    released.insert(released.end(), last.begin(), last.end());
  }
  return released;
}

std::vector<std::uint32_t> drop_strangers(FlatGroups& groups, std::uint32_t group) {
  std::vector<std::uint32_t>& members = groups.groups[group].triangles;
  std::erase_if(members, [&](std::uint32_t t) { return groups.of_triangle[t] != group; });
  if (members.size() >= 2) return {};
  for (const std::uint32_t t : members) groups.of_triangle[t] = kNone;
  return std::exchange(members, {});
}

}  // namespace spoctree
