#include "server/solid/grow_patches.hpp"

#include <limits>
#include <numeric>

namespace spoctree {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A triangle this many times longer than high, and no higher than the tolerance, may have its
// normal from rounding.
constexpr double kSliverAspect = 32;

// Other triangles have to face the patch's way, within 60 degrees: the rim of a plate thinner than
// the tolerance is no part of its top.
constexpr Int128 kSmallestScalarProduct = Int128{1} << (2 * kGridBits - 1);

struct TriangleShape {
  GridPlane plane;
  AreaVector area_vector{};
  double area = 0;
  bool is_sliver = false;
};

double length_of(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

double distance(const GridPoint& p, const GridPoint& q) {
  return length_of(static_cast<double>(q[0] - p[0]), static_cast<double>(q[1] - p[1]),
                   static_cast<double>(q[2] - p[2])) *
         0x1p-52;
}

TriangleShape shape_of(const GridPoint& a, const GridPoint& b, const GridPoint& c,
                       double tolerance) {
  TriangleShape shape;
  shape.area_vector = area_vector(a, b, c);
  shape.plane = nearest_plane(shape.area_vector, a);
  const double double_area = length_of(static_cast<double>(shape.area_vector[0]),
                                       static_cast<double>(shape.area_vector[1]),
                                       static_cast<double>(shape.area_vector[2])) *
                             0x1p-104;
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const double height = double_area / longest;
  shape.area = 0.5 * double_area;
  shape.is_sliver = height <= tolerance && height * kSliverAspect < longest;
  return shape;
}

class Grower {
 public:
  Grower(std::vector<SolidTriangle>& triangles, const std::vector<GridPoint>& points,
         double tolerance)
      : triangles_(triangles), points_(points), most_spread_(to_height(tolerance)) {
    shapes_.reserve(triangles.size());
    for (SolidTriangle& t : triangles) {
      t.facet = kNone;
      shapes_.push_back(
          shape_of(points[t.vertex[0]], points[t.vertex[1]], points[t.vertex[2]], tolerance));
    }
  }

  std::size_t count_distinct_planes() const;
  std::vector<PlanarPatch> grow_all();

 private:
  HeightRange heights(const GridPlane& plane, std::uint32_t t) const {
    HeightRange range;
    for (const std::uint32_t v : triangles_[t].vertex) range.add(plane.height(points_[v]));
    return range;
  }
  PlanarPatch grow(std::uint32_t seed, std::uint32_t number);
  bool faces_along(const GridPlane& plane, std::uint32_t t) const;
  bool fits(const PlanarPatch& patch, std::uint32_t t) const;
  bool is_within(const PlanarPatch& patch, std::uint32_t number, std::uint32_t t) const;
  void join(PlanarPatch& patch, std::uint32_t number, std::uint32_t t);
  PlanarPatch with_mean_normal(const PlanarPatch& patch) const;

  std::vector<SolidTriangle>& triangles_;
  const std::vector<GridPoint>& points_;
  Int128 most_spread_;
  std::vector<TriangleShape> shapes_;
  std::vector<std::uint32_t> reached_;  // the triangles of the patch that is growing
};

std::size_t Grower::count_distinct_planes() const {
  std::vector<GridPlane> planes;
  planes.reserve(shapes_.size());
  for (const TriangleShape& shape : shapes_) planes.push_back(shape.plane);
  std::sort(planes.begin(), planes.end());
  return static_cast<std::size_t>(std::unique(planes.begin(), planes.end()) - planes.begin());
}

bool Grower::faces_along(const GridPlane& plane, std::uint32_t t) const {
  return dot(shapes_[t].plane.normal, plane.normal) >= kSmallestScalarProduct;
}

bool Grower::fits(const PlanarPatch& patch, std::uint32_t t) const {
  HeightRange range = patch.range;
  range.add(heights(patch.plane, t));
  return range.spread() <= most_spread_;
}

// A sliver belongs to the patch wherever its normal points, if two of its neighbours do.
bool Grower::is_within(const PlanarPatch& patch, std::uint32_t number, std::uint32_t t) const {
  const auto& neighbours = triangles_[t].neighbour;
  return std::count_if(std::begin(neighbours), std::end(neighbours), [&](std::uint32_t n) {
           return triangles_[n].facet == number ||
                  (triangles_[n].facet == kNone && faces_along(patch.plane, n) && fits(patch, n));
         }) >= 2;
}

void Grower::join(PlanarPatch& patch, std::uint32_t number, std::uint32_t t) {
  if (shapes_[t].plane != patch.plane) {
    if (most_spread_ == 0 || !fits(patch, t)) return;
    if (!faces_along(patch.plane, t) && !(shapes_[t].is_sliver && is_within(patch, number, t))) {
      return;
    }
    patch.is_exact = false;
  }
  patch.range.add(heights(patch.plane, t));
  triangles_[t].facet = number;
  reached_.push_back(t);
}

PlanarPatch Grower::grow(std::uint32_t seed, std::uint32_t number) {
  PlanarPatch patch;
  patch.plane = shapes_[seed].plane;
  patch.range = heights(patch.plane, seed);
  triangles_[seed].facet = number;
  reached_.assign(1, seed);
  for (std::size_t fitted = 0;;) {
    for (std::size_t i = 0; i < reached_.size(); ++i) {
      for (const std::uint32_t n : triangles_[reached_[i]].neighbour) {
        if (triangles_[n].facet == kNone) join(patch, number, n);
      }
    }
    // The seed's own noise tilts its plane; the mean one may reach farther. Rounds that add little
    // are the last, so that all rounds together are linear.
    if (patch.is_exact || 8 * reached_.size() < 9 * fitted) break;
    fitted = reached_.size();
    const PlanarPatch mean = with_mean_normal(patch);
    if (mean.range.spread() > most_spread_) break;
    patch = mean;
  }
  const PlanarPatch mean = with_mean_normal(patch);
  if (patch.is_exact || mean.range.spread() >= patch.range.spread()) {
    patch.area = mean.area;
    return patch;
  }
  return mean;
}

// The patch that the reached triangles make with the mean of their normals, weighted by areas.
PlanarPatch Grower::with_mean_normal(const PlanarPatch& patch) const {
  long double sum[3] = {0, 0, 0};
  for (const std::uint32_t t : reached_) {
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += static_cast<long double>(shapes_[t].area_vector[i]);
    }
  }
  PlanarPatch mean = patch;
  mean.area = 0.5 *
              length_of(static_cast<double>(sum[0]), static_cast<double>(sum[1]),
                        static_cast<double>(sum[2])) *
              0x1p-104;
  if (patch.is_exact || mean.area == 0) return mean;
  mean.plane.normal = round_direction(sum[0], sum[1], sum[2]);
  mean.range = HeightRange{};
  for (const std::uint32_t t : reached_) mean.range.add(heights(mean.plane, t));
  mean.plane.offset = offset_above(mean.range.highest);
  return mean;
}

std::vector<PlanarPatch> Grower::grow_all() {
  std::vector<std::uint32_t> seeds(triangles_.size());
  std::iota(seeds.begin(), seeds.end(), 0);
  std::sort(seeds.begin(), seeds.end(), [&](std::uint32_t i, std::uint32_t j) {
    return shapes_[i].area != shapes_[j].area ? shapes_[i].area > shapes_[j].area : i < j;
  });
  std::vector<PlanarPatch> grown;
  for (const std::uint32_t seed : seeds) {
    if (triangles_[seed].facet != kNone) continue;
    grown.push_back(grow(seed, static_cast<std::uint32_t>(grown.size())));
  }
  std::vector<std::uint32_t> new_number(grown.size(), kNone);
  std::vector<PlanarPatch> ordered;
  ordered.reserve(grown.size());
  for (SolidTriangle& t : triangles_) {
    std::uint32_t& number = new_number[t.facet];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(ordered.size());
      ordered.push_back(grown[t.facet]);
    }
    t.facet = number;
  }
  return ordered;
}

}  // namespace

GrownPatches grow_patches(std::vector<SolidTriangle>& triangles,
                          const std::vector<GridPoint>& points, double tolerance) {
  Grower grower(triangles, points, tolerance);
  GrownPatches grown;
  grown.patches = grower.grow_all();
  grown.distinct_triangle_planes = grower.count_distinct_planes();
  return grown;
}

}  // namespace spoctree
