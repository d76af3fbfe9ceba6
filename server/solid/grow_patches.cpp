#include "server/solid/grow_patches.hpp"

#include <numeric>

#include "common/base/parallel.hpp"
#include "server/solid/fit_plane.hpp"

namespace spoctree {

namespace {

// A triangle this many times longer than high, and no higher than the tolerance, may have its
// normal from rounding.
constexpr double kSliverAspect = 32;

// Other triangles have to face the patch's way, within 60 degrees: the rim of a plate thinner than
// the tolerance is no part of its top.
constexpr Int128 kSmallestScalarProduct = Int128{1} << (2 * kGridBits - 1);

// Marks triangles that were seeds and found no neighbour that fits.
constexpr std::uint32_t kAlone = kNone - 1;

double distance(const GridPoint& p, const GridPoint& q) {
  const auto x = static_cast<double>(q[0] - p[0]);
  const auto y = static_cast<double>(q[1] - p[1]);
  const auto z = static_cast<double>(q[2] - p[2]);
  return std::sqrt(x * x + y * y + z * z) * 0x1p-52;
}

class Grower {
 public:
  Grower(const FlatSurface& surface, double tolerance)
      : surface_(surface),
        tolerance_(tolerance),
        most_spread_(to_height(tolerance)),
        patch_of_(surface.triangles.size(), kNone) {}

  std::vector<PlanarPatch> grow_all();

 private:
  HeightRange heights(const GridPlane& plane, std::uint32_t t) const {
    HeightRange range;
    for (const std::uint32_t v : surface_.triangles[t]) range.add(plane.height(surface_.points[v]));
    return range;
  }
  bool grow(std::uint32_t seed, std::uint32_t number, PlanarPatch& patch);
  bool faces_along(const GridPlane& plane, std::uint32_t t) const;
  bool is_sliver(std::uint32_t t) const;
  bool fits(const PlanarPatch& patch, std::uint32_t t) const;
  bool is_within(const PlanarPatch& patch, std::uint32_t number, std::uint32_t t) const;
  void join(PlanarPatch& patch, std::uint32_t number, std::uint32_t t);
  void fit(PlanarPatch& patch) const;

  const FlatSurface& surface_;
  double tolerance_;
  Int128 most_spread_;
  std::vector<std::uint32_t> patch_of_;
};

bool Grower::faces_along(const GridPlane& plane, std::uint32_t t) const {
  return dot(surface_.planes[t].normal, plane.normal) >= kSmallestScalarProduct;
}

bool Grower::is_sliver(std::uint32_t t) const {
  const Corners& c = surface_.triangles[t];
  const auto& p = surface_.points;
  const double longest = std::max(
      {distance(p[c[0]], p[c[1]]), distance(p[c[1]], p[c[2]]), distance(p[c[2]], p[c[0]])});
  const double height = 2 * surface_.areas[t] / longest;
  return height <= tolerance_ && height * kSliverAspect < longest;
}

bool Grower::fits(const PlanarPatch& patch, std::uint32_t t) const {
  HeightRange range = patch.range;
  range.add(heights(patch.plane, t));
  return range.spread() <= most_spread_;
}

// A sliver belongs to the patch wherever its normal points, if two of its neighbours do.
bool Grower::is_within(const PlanarPatch& patch, std::uint32_t number, std::uint32_t t) const {
  const Corners& neighbours = surface_.neighbours[t];
  return std::count_if(neighbours.begin(), neighbours.end(), [&](std::uint32_t n) {
           return patch_of_[n] == number ||
                  (patch_of_[n] == kNone && faces_along(patch.plane, n) && fits(patch, n));
         }) >= 2;
}

void Grower::join(PlanarPatch& patch, std::uint32_t number, std::uint32_t t) {
  if (surface_.planes[t] != patch.plane) {
    if (!fits(patch, t)) return;
    if (!faces_along(patch.plane, t) && !(is_sliver(t) && is_within(patch, number, t))) return;
    patch.is_exact = false;
  }
  patch.range.add(heights(patch.plane, t));
  patch_of_[t] = number;
  patch.triangles.push_back(t);
}

// False if the seed stays alone.
bool Grower::grow(std::uint32_t seed, std::uint32_t number, PlanarPatch& patch) {
  patch.plane = surface_.planes[seed];
  patch.range = heights(patch.plane, seed);
  patch.is_exact = true;
  patch.triangles.assign(1, seed);
  patch_of_[seed] = number;
  for (std::size_t fitted = 0;;) {
    for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
      for (const std::uint32_t n : surface_.neighbours[patch.triangles[i]]) {
        if (patch_of_[n] == kNone) join(patch, number, n);
      }
    }
    if (patch.triangles.size() == 1) {
      patch_of_[seed] = kAlone;
      return false;
    }
    // The seed's own noise tilts its plane; the mean one may reach farther. Rounds that add little
    // are the last, so that all rounds together are linear.
    if (patch.is_exact || 8 * patch.triangles.size() < 9 * fitted) break;
    fitted = patch.triangles.size();
    PlanarPatch mean = patch;
    fit(mean);
    if (mean.range.spread() > most_spread_) break;
    patch = std::move(mean);
  }
  const HeightRange grown = patch.range;
  const GridPlane plane = patch.plane;
  fit(patch);
  if (patch.range.spread() > std::max(grown.spread(), most_spread_)) {
    patch.plane = plane;
    patch.range = grown;
  }
  return true;
}

void Grower::fit(PlanarPatch& patch) const {
  const FittedPlane fitted = fit_plane(surface_, patch.triangles);
  patch.plane = fitted.plane;
  patch.is_exact = fitted.is_exact;
  patch.area = fitted.area;
  patch.range = HeightRange{};
  for (const std::uint32_t t : patch.triangles) patch.range.add(heights(patch.plane, t));
}

std::vector<PlanarPatch> Grower::grow_all() {
  std::vector<std::uint32_t> seeds(surface_.triangles.size());
  std::iota(seeds.begin(), seeds.end(), 0);
  parallel_sort(seeds, [&](std::uint32_t i, std::uint32_t j) {
    return surface_.areas[i] != surface_.areas[j] ? surface_.areas[i] > surface_.areas[j] : i < j;
  });
  std::vector<PlanarPatch> grown;
  PlanarPatch patch;
  for (const std::uint32_t seed : seeds) {
    if (patch_of_[seed] != kNone) continue;
    if (!grow(seed, static_cast<std::uint32_t>(grown.size()), patch)) continue;
    grown.push_back(patch);
  }
  return grown;
}

}  // namespace

std::vector<PlanarPatch> grow_patches(const FlatSurface& surface, double tolerance) {
  return Grower(surface, tolerance).grow_all();
}

}  // namespace spoctree
