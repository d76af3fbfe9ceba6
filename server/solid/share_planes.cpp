#include "server/solid/share_planes.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <unordered_map>

namespace spoctree {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Planes are filed in cells of this side in the space of normals and offsets.
constexpr double kCell = 0x1p-10;

struct PlaneHash {
  std::size_t operator()(const GridPlane& plane) const {
    std::uint64_t hash = static_cast<std::uint64_t>(plane.offset);
    for (const std::int64_t n : plane.normal) {
      hash = (hash ^ (hash >> 29)) * 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(n);
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

class PlaneSharer {
 public:
  PlaneSharer(const Solid& solid, const std::vector<GridPoint>& points, double tolerance)
      : solid_(solid), points_(points), tolerance_(tolerance), most_spread_(to_height(tolerance)) {}

  /// The number of the plane for a patch, a new one if none fits.
  std::uint32_t find_or_add(const PlanarPatch& patch, std::uint32_t facet);
  std::vector<SharedPlane> planes;

 private:
  std::uint32_t find_near(const PlanarPatch& patch, std::uint32_t facet);
  bool join(std::uint32_t plane, const HeightRange& range) {
    HeightRange joint = planes[plane].range;
    joint.add(range);
    if (joint.spread() > most_spread_) return false;
    planes[plane].range = joint;
    return true;
  }
  HeightRange heights(const GridPlane& plane, std::uint32_t facet) const {
    HeightRange range;
    for (const std::uint32_t v : solid_.vertices_of_facet(facet))
      range.add(plane.height(points_[v]));
    return range;
  }
  double largest_tilt(const PlanarPatch& patch, std::uint32_t facet) const;
  static std::uint64_t cell_of(const std::array<std::int64_t, 4>& cell) {
    std::uint64_t key = 0;
    for (const std::int64_t c : cell) key = (key << 14) | static_cast<std::uint64_t>(c + (1 << 13));
    return key;
  }

  const Solid& solid_;
  const std::vector<GridPoint>& points_;
  double tolerance_;
  Int128 most_spread_;
  std::unordered_map<GridPlane, std::uint32_t, PlaneHash> exact_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

// By how much the normal of a plane within the tolerance of the facet's corners can differ from the
// facet's own: the narrower the facet, the more. Larger tilts than half a cell are not looked for.
double PlaneSharer::largest_tilt(const PlanarPatch& patch, std::uint32_t facet) const {
  const auto corners = solid_.vertices_of_facet(facet);
  Vec3 lower = solid_.vertices[corners[0]];
  Vec3 upper = lower;
  for (const std::uint32_t v : corners) {
    lower = glm::min(lower, solid_.vertices[v]);
    upper = glm::max(upper, solid_.vertices[v]);
  }
  const double width = patch.area / glm::distance(lower, upper);
  return std::min(kCell / 2, 2 * tolerance_ / width + 0x1p-50);
}

std::uint32_t PlaneSharer::find_near(const PlanarPatch& patch, std::uint32_t facet) {
  const double tilt = largest_tilt(patch, facet);
  // Points of the universe cube are at most sqrt(3) from the origin.
  const double shift = std::min(kCell / 2, 1.75 * tilt + 2 * tolerance_);
  const Plane plane = patch.plane.to_plane();
  const double centre[4] = {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
  std::array<std::int64_t, 4> first;
  std::array<std::int64_t, 4> last;
  for (std::size_t i = 0; i < 4; ++i) {
    const double margin = i < 3 ? tilt : shift;
    first[i] = static_cast<std::int64_t>(std::floor((centre[i] - margin) / kCell));
    last[i] = static_cast<std::int64_t>(std::floor((centre[i] + margin) / kCell));
  }
  std::vector<std::uint32_t> candidates;
  std::array<std::int64_t, 4> cell;
  for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0]) {
    for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1]) {
      for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) {
        for (cell[3] = first[3]; cell[3] <= last[3]; ++cell[3]) {
          const auto found = cells_.find(cell_of(cell));
          if (found == cells_.end()) continue;
          candidates.insert(candidates.end(), found->second.begin(), found->second.end());
        }
      }
    }
  }
  std::sort(candidates.begin(), candidates.end());
  for (const std::uint32_t candidate : candidates) {
    const GridPlane& other = planes[candidate].plane;
    if (dot(other.normal, patch.plane.normal) <= 0) continue;
    if (join(candidate, heights(other, facet))) return candidate;
  }
  return kNone;
}

std::uint32_t PlaneSharer::find_or_add(const PlanarPatch& patch, std::uint32_t facet) {
  const auto next = static_cast<std::uint32_t>(planes.size());
  if (patch.is_exact) {
    const auto [entry, is_new] = exact_.try_emplace(patch.plane, next);
    if (!is_new) {
      planes[entry->second].range.add(heights(planes[entry->second].plane, facet));
      return entry->second;
    }
  }
  if (most_spread_ > 0) {
    const std::uint32_t near = find_near(patch, facet);
    if (near != kNone) {
      // Equal planes must not be sent here: the rounding of their offsets is not held against them.
      if (patch.is_exact) exact_.erase(patch.plane);
      return near;
    }
    const Plane plane = patch.plane.to_plane();
    const double centre[4] = {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
    std::array<std::int64_t, 4> cell;
    for (std::size_t i = 0; i < 4; ++i) {
      cell[i] = static_cast<std::int64_t>(std::floor(centre[i] / kCell));
    }
    cells_[cell_of(cell)].push_back(next);
  }
  planes.push_back({patch.plane, patch.range});
  return next;
}

}  // namespace

SharedPlanes share_planes(const std::vector<PlanarPatch>& patches, const Solid& solid,
                          const std::vector<GridPoint>& points, double tolerance) {
  std::vector<std::uint32_t> order(patches.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return patches[i].area > patches[j].area;
  });
  PlaneSharer sharer(solid, points, tolerance);
  std::vector<std::uint32_t> found(patches.size());
  for (const std::uint32_t patch : order) found[patch] = sharer.find_or_add(patches[patch], patch);

  SharedPlanes shared;
  std::vector<std::uint32_t> new_number(sharer.planes.size(), kNone);
  for (const std::uint32_t old : found) {
    if (new_number[old] == kNone) {
      new_number[old] = static_cast<std::uint32_t>(shared.planes.size());
      shared.planes.push_back(sharer.planes[old]);
    }
    shared.plane_of_patch.push_back(new_number[old]);
  }
  return shared;
}

}  // namespace spoctree
