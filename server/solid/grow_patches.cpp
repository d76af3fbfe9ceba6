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
  bool join(PlanarPatch& patch, std::uint32_t number, std::uint32_t t) const;
  bool is_aligned(const PlanarPatch& patch, std::uint32_t number, std::uint32_t t) const;
  void fit(PlanarPatch& patch) const;

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

// A sliver between two triangles of the patch is a part of it wherever its normal points.
bool Grower::is_aligned(const PlanarPatch& patch, std::uint32_t number, std::uint32_t t) const {
  if (dot(shapes_[t].plane.normal, patch.plane.normal) >= kSmallestScalarProduct) return true;
  if (!shapes_[t].is_sliver) return false;
  const auto& neighbours = triangles_[t].neighbour;
  return std::count_if(std::begin(neighbours), std::end(neighbours),
                       [&](std::uint32_t n) { return triangles_[n].facet == number; }) >= 2;
}

// The patch keeps the seed's plane while it grows; it becomes wider, never tilted.
bool Grower::join(PlanarPatch& patch, std::uint32_t number, std::uint32_t t) const {
  HeightRange range = patch.range;
  range.add(heights(patch.plane, t));
  if (shapes_[t].plane != patch.plane) {
    if (most_spread_ == 0 || range.spread() > most_spread_) return false;
    if (!is_aligned(patch, number, t)) return false;
    patch.is_exact = false;
  }
  patch.range = range;
  return true;
}

PlanarPatch Grower::grow(std::uint32_t seed, std::uint32_t number) {
  PlanarPatch patch;
  patch.plane = shapes_[seed].plane;
  patch.range = heights(patch.plane, seed);
  triangles_[seed].facet = number;
  reached_.assign(1, seed);
  for (std::size_t i = 0; i < reached_.size(); ++i) {
    for (const std::uint32_t n : triangles_[reached_[i]].neighbour) {
      if (triangles_[n].facet != kNone || !join(patch, number, n)) continue;
      triangles_[n].facet = number;
      reached_.push_back(n);
    }
  }
  fit(patch);
  return patch;
}

// Takes the mean normal instead of the seed's where that brings the corners nearer to the plane.
void Grower::fit(PlanarPatch& patch) const {
  if (reached_.size() == 1) {
    patch.area = shapes_[reached_[0]].area;
    return;
  }
  long double sum[3] = {0, 0, 0};
  for (const std::uint32_t t : reached_) {
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += static_cast<long double>(shapes_[t].area_vector[i]);
    }
  }
  patch.area = 0.5 *
               length_of(static_cast<double>(sum[0]), static_cast<double>(sum[1]),
                         static_cast<double>(sum[2])) *
               0x1p-104;
  if (patch.is_exact || (sum[0] == 0 && sum[1] == 0 && sum[2] == 0)) return;
  GridPlane mean;
  mean.normal = round_direction(sum[0], sum[1], sum[2]);
  HeightRange range;
  for (const std::uint32_t t : reached_) range.add(heights(mean, t));
  if (range.spread() >= patch.range.spread()) return;
  mean.offset = offset_above(range.highest);
  patch.plane = mean;
  patch.range = range;
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
