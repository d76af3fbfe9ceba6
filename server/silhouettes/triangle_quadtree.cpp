#include "server/silhouettes/triangle_quadtree.hpp"

#include <algorithm>
#include <cmath>

namespace spoctree {

namespace {

/// Then triangles are as small as the pixels of a picture of 2048 x 2048.
constexpr int kMostDivisions = 10;

/// Side 1 is the cube's. Centres of triangles that share a side are sqrt(2) / 3 apart in the
/// hexagon's triangles, whose side is sqrt(2 / 3), and half as far with each division.
int divisions_for(const Mask& mask) {
  const double pixel = std::min(std::sqrt(2.0) / mask.width, std::sqrt(8.0 / 3.0) / mask.height);
  double distance = std::sqrt(2.0) / 3;
  int divisions = 0;
  while (distance > pixel && divisions < kMostDivisions) {
    distance /= 2;
    ++divisions;
  }
  return divisions;
}

/// The pixel nearest to a place between 0 and 1.
int pixel_at(double place, int pixels) {
  return std::clamp(static_cast<int>(std::floor(place * pixels)), 0, pixels - 1);
}

}  // namespace

TriangleQuadtrees::TriangleQuadtrees(const Mask& mask) : depth_(divisions_for(mask)) {
  // The ends of the spokes, as the picture is stretched.
  constexpr std::array<Point, 6> kSpokes{
      {{-1, -0.5}, {-1, 0.5}, {0, 1}, {1, 0.5}, {1, -0.5}, {0, -1}}};
  triangles_.resize(6);
  for (std::size_t p = 0; p < 6; ++p) {
    roots_[p] = static_cast<Triangle>(p);
    Corners corners;
    corners.points_right = p % 2 == 0;
    const CornerLabels& labels = kCornerLabels[p];
    corners.labelled[static_cast<std::size_t>(labels.centre - 1)] = {0, 0};
    corners.labelled[static_cast<std::size_t>(labels.first - 1)] = kSpokes[p];
    corners.labelled[static_cast<std::size_t>(labels.second - 1)] = kSpokes[(p + 1) % 6];
    triangles_[p] = build(mask, corners, 0);
  }
}

TriangleQuadtrees::Corners TriangleQuadtrees::part_corners(const Corners& corners,
                                                           std::size_t label) {
  const auto middle = [&](std::size_t a, std::size_t b) {
    const Point& p = corners.labelled[a - 1];
    const Point& q = corners.labelled[b - 1];
    return Point{(p.right + q.right) / 2, (p.up + q.up) / 2};
  };
  if (label == 0) {
    if (corners.points_right) return {{middle(1, 2), middle(2, 3), middle(1, 3)}, false};
    return {{middle(1, 3), middle(1, 2), middle(2, 3)}, true};
  }
  return {{middle(label, 1), middle(label, 2), middle(label, 3)}, corners.points_right};
}

TriangleQuadtrees::Node TriangleQuadtrees::build(const Mask& mask, const Corners& corners,
                                                 int depth) {
  if (depth == depth_) {
    const auto& [a, b, c] = corners.labelled;
    const int column = pixel_at(0.5 + (a.right + b.right + c.right) / 6, mask.width);
    const int row = pixel_at(0.5 - (a.up + b.up + c.up) / 6, mask.height);
    return {static_cast<float>(mask.at(column, row)), 0};
  }
  std::array<Node, 4> parts;
  float share = 0;  // exact: multiples of 4^-kMostDivisions
  for (std::size_t label = 0; label < 4; ++label) {
    parts[label] = build(mask, part_corners(corners, label), depth + 1);
    share += parts[label].black_share / 4;
  }
  if (share == 0 || share == 1) return {share, 0};
  const auto first = static_cast<std::uint32_t>(triangles_.size());
  triangles_.insert(triangles_.end(), parts.begin(), parts.end());
  return {share, first};
}

}  // namespace spoctree
