#include "server/solid/share_planes.hpp"

#include <array>
#include <numeric>
#include <unordered_map>

namespace spoctree {

namespace {

// Planes are filed in cells of this side in the space of normals and offsets.
constexpr double kCell = 0x1p-10;

// A place among the planes: three components of the normal, and the offset.
using Place = std::array<double, 4>;
using Cell = std::array<std::int64_t, 4>;

Place place_of(const GridPlane& grid_plane) {
  const Plane plane = grid_plane.to_plane();
  return {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
}

std::int64_t cell_coordinate(double value) {
  return static_cast<std::int64_t>(std::floor(value / kCell));
}

// Coordinates are at most 2 / kCell in magnitude.
std::uint64_t key_of(const Cell& cell) {
  std::uint64_t key = 0;
  for (const std::int64_t c : cell) key = (key << 14) | static_cast<std::uint64_t>(c + (1 << 13));
  return key;
}

// A plane and the heights of the corners of all its patches above it.
struct SharedPlane {
  GridPlane plane;
  HeightRange range;
};

class PlaneSharer {
 public:
  PlaneSharer(const FlatSurface& surface, double tolerance)
      : surface_(surface), tolerance_(tolerance), most_spread_(to_height(tolerance)) {}

  /// The number of the plane for a patch, a new one if none fits.
  std::uint32_t find_or_add(const PlanarPatch& patch);

 private:
  std::uint32_t find(const PlanarPatch& patch);
  void collect_candidates(const Place& place, const Place& margin);
  bool join(SharedPlane& shared, const PlanarPatch& patch) const;
  double largest_tilt(const PlanarPatch& patch) const;

  const FlatSurface& surface_;
  double tolerance_;
  Int128 most_spread_;
  std::vector<SharedPlane> planes_;
  std::unordered_map<std::uint64_t, std::uint32_t> newest_in_cell_;
  std::vector<std::uint32_t> next_in_cell_;  // for each plane: the one before it in its cell
  std::vector<std::uint32_t> candidates_;
};

// By how much the normal of a plane within the tolerance of the patch's corners can differ from the
// patch's own: the narrower the patch, the more. Larger tilts than half a cell are not looked for.
double PlaneSharer::largest_tilt(const PlanarPatch& patch) const {
  const std::uint32_t any = surface_.triangles[patch.triangles.front()][0];
  GridPoint lower = surface_.points[any];
  GridPoint upper = lower;
  for (const std::uint32_t t : patch.triangles) {
    for (const std::uint32_t v : surface_.triangles[t]) {
      for (std::size_t i = 0; i < 3; ++i) {
        lower[i] = std::min(lower[i], surface_.points[v][i]);
        upper[i] = std::max(upper[i], surface_.points[v][i]);
      }
    }
  }
  double squared_diagonal = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double side = static_cast<double>(upper[i] - lower[i]) * 0x1p-52;
    squared_diagonal += side * side;
  }
  const double width = patch.area / std::sqrt(squared_diagonal);
  return std::min(kCell / 2, 2 * tolerance_ / width + 0x1p-50);
}

// All planes within the margin of the place, the oldest (of the largest patch) first.
void PlaneSharer::collect_candidates(const Place& place, const Place& margin) {
  Cell first;
  Cell last;
  for (std::size_t i = 0; i < 4; ++i) {
    first[i] = cell_coordinate(place[i] - margin[i]);
    last[i] = cell_coordinate(place[i] + margin[i]);
  }
  const auto is_near = [&](std::uint32_t candidate) {
    const Place other = place_of(planes_[candidate].plane);
    for (std::size_t i = 0; i < 4; ++i) {
      if (std::abs(other[i] - place[i]) > margin[i]) return false;
    }
    return true;
  };
  candidates_.clear();
  Cell cell = first;
  for (;;) {
    const auto found = newest_in_cell_.find(key_of(cell));
    for (std::uint32_t candidate = found == newest_in_cell_.end() ? kNone : found->second;
         candidate != kNone; candidate = next_in_cell_[candidate]) {
      if (is_near(candidate)) candidates_.push_back(candidate);
    }
    std::size_t i = 0;
    while (i < 4 && cell[i] == last[i]) {
      cell[i] = first[i];
      ++i;
    }
    if (i == 4) break;
    ++cell[i];
  }
  std::sort(candidates_.begin(), candidates_.end());
}

bool PlaneSharer::join(SharedPlane& shared, const PlanarPatch& patch) const {
  HeightRange range = shared.range;
  for (const std::uint32_t t : patch.triangles) {
    for (const std::uint32_t v : surface_.triangles[t]) {
      range.add(shared.plane.height(surface_.points[v]));
    }
  }
  // What equal planes differ by is the rounding to the grid, and not held against them.
  if (shared.plane != patch.plane && range.spread() > most_spread_) return false;
  shared.range = range;
  return true;
}

std::uint32_t PlaneSharer::find(const PlanarPatch& patch) {
  const double tilt = largest_tilt(patch);
  // Points of the universe cube are at most sqrt(3) from the origin.
  const double shift = std::min(kCell / 2, 1.75 * tilt + 2 * tolerance_);
  collect_candidates(place_of(patch.plane), {tilt, tilt, tilt, shift});
  for (const std::uint32_t candidate : candidates_) {
    if (join(planes_[candidate], patch)) return candidate;
  }
  return kNone;
}

std::uint32_t PlaneSharer::find_or_add(const PlanarPatch& patch) {
  const std::uint32_t found = find(patch);
  if (found != kNone) return found;
  const auto number = static_cast<std::uint32_t>(planes_.size());
  planes_.push_back({patch.plane, patch.range});
  const Place place = place_of(patch.plane);
  const std::uint64_t key = key_of({cell_coordinate(place[0]), cell_coordinate(place[1]),
                                    cell_coordinate(place[2]), cell_coordinate(place[3])});
  const auto [entry, is_first] = newest_in_cell_.try_emplace(key, number);
  next_in_cell_.push_back(is_first ? kNone : entry->second);
  entry->second = number;
  return number;
}

}  // namespace

std::vector<std::uint32_t> share_planes(const std::vector<PlanarPatch>& patches,
                                        const FlatSurface& surface, double tolerance) {
  std::vector<std::uint32_t> order(patches.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return patches[i].area > patches[j].area;
  });
  PlaneSharer sharer(surface, tolerance);
  std::vector<std::uint32_t> plane_of_patch(patches.size());
  for (const std::uint32_t patch : order) {
    plane_of_patch[patch] = sharer.find_or_add(patches[patch]);
  }
  return plane_of_patch;
}

}  // namespace spoctree
