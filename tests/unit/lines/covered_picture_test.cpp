#include "client/lines/covered_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "common/base/errors.hpp"
#include "tests/support/random.hpp"

namespace spoctree {
namespace {

constexpr double kTolerance = 1e-10;

CoveredPicture picture_of_square(std::size_t tiles_per_side) {
  return CoveredPicture({{-1, -1}, {1, 1}}, tiles_per_side * tiles_per_side);
}

/// The parts of the line from a to b that are not covered, merged, as parameters.
std::vector<Interval> uncovered(CoveredPicture& picture, Vec2 a, Vec2 b) {
  std::vector<Interval> parts;
  picture.find_uncovered(a, b, {0, 1}, parts);
  std::sort(parts.begin(), parts.end(),
            [](const Interval& p, const Interval& q) { return p.begin < q.begin; });
  std::vector<Interval> merged;
  for (const Interval& part : parts) {
    if (!merged.empty() && part.begin <= merged.back().end + 1e-9) {
      merged.back().end = std::max(merged.back().end, part.end);
    } else {
      merged.push_back(part);
    }
  }
  return merged;
}

void cover(CoveredPicture& picture, std::vector<Vec2> polygon) {
  picture.cover(polygon, kTolerance);
}

/// The triangles of a net of n x n wry squares over the square -1 .. 1.
std::vector<std::vector<Vec2>> net_of_triangles(std::uint32_t n, Random& random, double noise) {
  std::vector<Vec2> points;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t j = 0; j <= n; ++j) {
      const bool inside = i > 0 && i < n && j > 0 && j < n;
      const double reach = inside ? 0.3 : 0;
      points.push_back({(i + random.between(-reach, reach)) / n * 2 - 1,
                        (j + random.between(-reach, reach)) / n * 2 - 1});
    }
  }
  std::vector<std::vector<Vec2>> triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const Vec2 a = points[i * (n + 1) + j];
      const Vec2 b = points[(i + 1) * (n + 1) + j];
      const Vec2 c = points[(i + 1) * (n + 1) + j + 1];
      const Vec2 d = points[i * (n + 1) + j + 1];
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }
  // Each triangle has its own idea of where its corners are, as pieces of a solid have.
  for (auto& triangle : triangles) {
    for (Vec2& corner : triangle) {
      corner += noise * Vec2{random.between(-1, 1), random.between(-1, 1)};
    }
  }
  return triangles;
}

TEST(CoveredPicture, CoversNothingAtFirst) {
  for (const std::uint32_t tiles : {1u, 3u, 64u}) {
    CoveredPicture picture = picture_of_square(tiles);
    const auto parts = uncovered(picture, {-0.9, -0.7}, {0.8, 0.9});
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].begin, 0);
    EXPECT_EQ(parts[0].end, 1);
    EXPECT_FALSE(picture.is_full({{-0.5, -0.5}, {0.5, 0.5}}));
  }
}

TEST(CoveredPicture, CutsALineAtTheBordersOfAPolygon) {
  for (const std::uint32_t tiles : {1u, 2u, 7u, 100u}) {
    CoveredPicture picture = picture_of_square(tiles);
    cover(picture, {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
    const auto parts = uncovered(picture, {-1, 0.1}, {1, 0.1});
    ASSERT_EQ(parts.size(), 2u) << tiles << " tiles";
    EXPECT_NEAR(parts[0].end, 0.25, 2e-10);
    EXPECT_NEAR(parts[1].begin, 0.75, 2e-10);
  }
}

TEST(CoveredPicture, CoversItsBorders) {
  for (const std::uint32_t tiles : {1u, 5u, 30u}) {
    CoveredPicture picture = picture_of_square(tiles);
    cover(picture, {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
    EXPECT_TRUE(uncovered(picture, {-0.4, -0.5}, {0.4, -0.5}).empty());
    EXPECT_TRUE(uncovered(picture, {0.5, 0.4}, {0.5, -0.5}).empty());
    EXPECT_EQ(uncovered(picture, {-0.4, -0.5 - 1e-9}, {0.4, -0.5 - 1e-9}).size(), 1u);
  }
}

TEST(CoveredPicture, HidesALineUnderTheSeamOfTwoPolygons) {
  for (const std::uint32_t tiles : {1u, 9u}) {
    CoveredPicture picture = picture_of_square(tiles);
    cover(picture, {{-0.5, -0.3}, {0.1, -0.5}, {0.2, 0.5}, {-0.5, 0.5}});
    cover(picture, {{0.1 + 1e-14, -0.5}, {0.7, -0.4}, {0.6, 0.4}, {0.2 - 1e-14, 0.5}});
    EXPECT_TRUE(uncovered(picture, {0.1, -0.5}, {0.2, 0.5}).empty());
    EXPECT_TRUE(uncovered(picture, {-0.2, 0}, {0.5, 0.1}).empty());
  }
}

TEST(CoveredPicture, HasNoGapsInANetOfTriangles) {
  Random random(7);
  for (const double noise : {0.0, 1e-12}) {
    for (const std::uint32_t n : {2u, 5u, 16u, 40u}) {
      for (const std::uint32_t tiles : {3u, 10u, 50u}) {
        CoveredPicture picture = picture_of_square(tiles);
        auto triangles = net_of_triangles(n, random, noise);
        for (std::size_t k = triangles.size(); k > 1; --k) {
          std::swap(triangles[k - 1], triangles[random.below(static_cast<std::uint32_t>(k))]);
        }
        const std::vector<Vec2> last = triangles.back();
        triangles.pop_back();
        for (const auto& triangle : triangles) picture.cover(triangle, kTolerance);
        // One triangle is missing, and it shows.
        const Vec2 middle = (last[0] + last[1] + last[2]) / 3.0;
        EXPECT_FALSE(picture.is_full({middle, middle}));
        EXPECT_EQ(uncovered(picture, middle, 0.5 * (middle + last[0])).size(), 1u);
        picture.cover(last, kTolerance);
        EXPECT_TRUE(uncovered(picture, {-0.99, -0.98}, {0.97, 0.99}).empty());
      }
    }
  }
}

TEST(CoveredPicture, KnowsThatItIsFullBehindOneLargePolygonOrManySmallOnes) {
  CoveredPicture picture = picture_of_square(7);
  EXPECT_FALSE(picture.is_full({{-0.1, -0.1}, {0.1, 0.1}}));
  cover(picture, {{-0.6, -0.6}, {0.6, -0.6}, {0.6, 0.6}, {-0.6, 0.6}});
  EXPECT_TRUE(picture.is_full({{-0.1, -0.1}, {0.1, 0.1}}));
  EXPECT_FALSE(picture.is_full({{-0.1, -0.1}, {0.9, 0.1}}));

  // The same seams again and again, as in views along the walls of cells.
  Random random(7);
  CoveredPicture seams = picture_of_square(3);
  const auto triangles = net_of_triangles(2, random, 0);
  for (int layer = 0; layer < 64; ++layer) {
    for (const auto& triangle : triangles) seams.cover(triangle, kTolerance);
  }
  EXPECT_TRUE(seams.is_full({{-0.3, -0.3}, {0.3, 0.3}}));
}

TEST(CoveredPicture, IsFullOutOfBounds) {
  EXPECT_TRUE(picture_of_square(4).is_full({{2, 2}, {3, 3}}));
  EXPECT_TRUE(
      uncovered(*std::make_unique<CoveredPicture>(picture_of_square(4)), {2, 0}, {3, 0}).empty());
}

TEST(CoveredPicture, FindsLinesThatLeaveTheBounds) {
  CoveredPicture picture = picture_of_square(4);
  const auto parts = uncovered(picture, {-3, 0}, {3, 0.1});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].begin, 1.0 / 3, 0.02);
  EXPECT_NEAR(parts[0].end, 2.0 / 3, 0.02);
}

TEST(CoveredPicture, KeepsTheBorderOfASmallHoleExactly) {
  // A frame of four trapezoids around a hole of 1e-3, in one large tile.
  CoveredPicture picture = picture_of_square(1);
  const double h = 0.5e-3;
  const Vec2 inner[4] = {{-h, -h}, {h, -h}, {h, h}, {-h, h}};
  const Vec2 outer[4] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int k = 0; k < 4; ++k) {
    cover(picture, {outer[k], outer[(k + 1) % 4], inner[(k + 1) % 4], inner[k]});
  }
  const auto parts = uncovered(picture, {-0.1, 0}, {0.1, 0});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].begin, (0.1 - h) / 0.2, 1e-9);
  EXPECT_NEAR(parts[0].end, (0.1 + h) / 0.2, 1e-9);
}

TEST(CoveredPicture, SurvivesThousandsOfNeedlesInOneTile) {
  CoveredPicture picture = picture_of_square(1);
  for (int k = 0; k < 5000; ++k) {
    const double x = -0.9 + 1.8 * k / 5000;
    cover(picture, {{x, -0.9}, {x + 1.8 / 5000, -0.9}, {x + 1.8 / 5000 + 1e-5, 0.9}, {x, 0.9}});
  }
  EXPECT_TRUE(uncovered(picture, {-0.8, -0.8}, {0.5, 0.8}).empty());
}

TEST(CoveredPicture, RefusesMoreOutlinesInTilesThanItsLimit) {
  CoveredPicture picture({{-1, -1}, {1, 1}}, 1, 3);
  // Each in the one tile, none covers it.
  const auto cover_at = [&](double x) {
    cover(picture, {{x, -0.5}, {x + 0.1, -0.5}, {x + 0.1, 0.5}, {x, 0.5}});
  };
  for (const double x : {-0.8, -0.4, 0.0}) cover_at(x);
  try {
    cover_at(0.4);
    FAIL() << "too many are taken";
  } catch (const BadInput& error) {
    EXPECT_STREQ(error.what(), "more than 3 outlines in tiles of a picture");
  }
}

}  // namespace
}  // namespace spoctree
