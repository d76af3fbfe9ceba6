#include "server/silhouettes/render_silhouette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.hpp"

namespace spoctree {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// In the y-z plane, seen from +x: y to the right, z upwards.
Mask seen_from_x(const std::vector<glm::dvec3>& points, const Triangles& triangles, int size) {
  return render_silhouette(*find_view("face-x"), points, triangles, size, size);
}

std::size_t count(const Mask& mask) {
  return static_cast<std::size_t>(std::count(mask.pixels.begin(), mask.pixels.end(), 1));
}

TEST(RenderSilhouette, SetsThePixelsWhoseCentresAreCovered) {
  const std::vector<glm::dvec3> square{
      {0, -0.5, -0.5}, {0, 0.5, -0.5}, {0, 0.5, 0.5}, {0, -0.5, 0.5}};
  const Mask mask = seen_from_x(square, {{0, 1, 2}, {0, 2, 3}}, 8);
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      EXPECT_EQ(mask.at(column, row), column >= 2 && column < 6 && row >= 2 && row < 6);
    }
  }
}

TEST(RenderSilhouette, CountsCentresOnTheBorder) {
  // From the centre of pixel 1 to that of pixel 2, of four: -0.25 to 0.25.
  const std::vector<glm::dvec3> square{
      {0, -0.25, -0.25}, {0, 0.25, -0.25}, {0, 0.25, 0.25}, {0, -0.25, 0.25}};
  EXPECT_EQ(count(seen_from_x(square, {{0, 1, 2}, {0, 2, 3}}, 4)), 4u);
  // A needle through the centres of a diagonal.
  const std::vector<glm::dvec3> needle{{0, -1, -1}, {0, 1, 1}, {0, 0, 0}};
  EXPECT_EQ(count(seen_from_x(needle, {{0, 1, 2}}, 4)), 4u);
}

TEST(RenderSilhouette, LeavesNoGapBetweenNeighbours) {
  // A fan that fills the picture, from any middle.
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    std::vector<glm::dvec3> points{{0, random.between(-1, 1), random.between(-1, 1)}};
    Triangles triangles;
    constexpr std::array<std::array<double, 2>, 4> kCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (const auto& [y, z] : kCorners) points.emplace_back(0, y, z);
    for (std::uint32_t i = 0; i < 4; ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % 4});
    EXPECT_EQ(count(seen_from_x(points, triangles, 37)), 37u * 37u);
  }
}

TEST(RenderSilhouette, AgreesWithTheSidesOfATriangle) {
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 3; ++i)
      points.emplace_back(0, random.between(-1.5, 1.5), random.between(-1.5, 1.5));
    const Mask mask = seen_from_x(points, {{0, 1, 2}}, 16);
    for (int row = 0; row < 16; ++row) {
      for (int column = 0; column < 16; ++column) {
        const double y = (column + 0.5) / 8 - 1;
        const double z = 1 - (row + 0.5) / 8;
        double least = 1e9;
        double most = -1e9;
        for (std::size_t i = 0; i < 3; ++i) {
          const glm::dvec3& a = points[i];
          const glm::dvec3& b = points[(i + 1) % 3];
          const double side = (b.y - a.y) * (z - a.z) - (b.z - a.z) * (y - a.y);
          least = std::min(least, side);
          most = std::max(most, side);
        }
        if (std::abs(least) < 1e-4 || std::abs(most) < 1e-4) continue;  // points are rounded
        EXPECT_EQ(mask.at(column, row) == 1, least > 0 || most < 0);
      }
    }
  }
}

TEST(RenderSilhouette, ShowsTheWholeCubeInEveryView) {
  std::vector<glm::dvec3> corners;
  for (int octant = 0; octant < 8; ++octant) corners.emplace_back(towards_octant(octant));
  Triangles triangles;  // any three corners: their hull is the cube's
  for (std::uint32_t a = 0; a < 8; ++a) {
    for (std::uint32_t b = a + 1; b < 8; ++b) {
      for (std::uint32_t c = b + 1; c < 8; ++c) triangles.push_back({a, b, c});
    }
  }
  for (const View& view : all_views()) {
    const Mask mask = render_silhouette(view, corners, triangles, 64, 64);
    // A hexagon is three quarters of the rectangle around it.
    const double share = static_cast<double>(count(mask)) / (64 * 64);
    EXPECT_NEAR(share, view.kind == ViewKind::Corner ? 0.75 : 1, 0.02) << view.name;
    if (view.kind != ViewKind::Corner) {
      EXPECT_EQ(share, 1);
    }
  }
}

}  // namespace
}  // namespace spoctree
