#include "server/solid/flat_groups.hpp"

#include "server/solid/fit_plane.hpp"
#include "server/solid/grow_patches.hpp"
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

}  // namespace

FlatGroups find_flat_groups(const FlatSurface& surface, double tolerance) {
  std::vector<PlanarPatch> patches = grow_patches(surface, tolerance);
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
    FlatGroup& group = found.groups[g];
    const FittedPlane fitted = fit_plane(surface, group.triangles);
    group.plane = fitted.plane;
    group.area = fitted.area;
    group.is_exact = fitted.is_exact;
    for (const std::uint32_t t : group.triangles) found.of_triangle[t] = g;
  }
  return found;
}

}  // namespace spoctree
