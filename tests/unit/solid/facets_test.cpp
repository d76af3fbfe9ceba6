// Which triangles become one facet, which facets share a plane, and how exact the planes are.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <set>

#include "server/solid/grid_plane.hpp"
#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;

// A box whose top is a grid of n x n squares, each cut into two triangles; the inner vertices of
// the top are lifted by `lift(i, j)`.
template <class Lift>
PolygonSoup box_with_gridded_top(std::uint32_t n, Lift lift) {
  PolygonSoup soup;
  const auto point = [&](std::uint32_t i, std::uint32_t j) { return j * (n + 1) + i; };
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      const bool is_inner = i > 0 && j > 0 && i < n && j < n;
      soup.points.emplace_back(static_cast<double>(i) / n, static_cast<double>(j) / n,
                               1 + (is_inner ? lift(i, j) : 0));
    }
  }
  const auto bottom = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  std::vector<Face> faces = {{bottom, bottom + 3, bottom + 2, bottom + 1}};
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      faces.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
      faces.push_back({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  }
  Face front = {bottom, bottom + 1}, right = {bottom + 1, bottom + 2};
  Face back = {bottom + 2, bottom + 3}, left = {bottom + 3, bottom};
  for (std::uint32_t i = 0; i <= n; ++i) {
    front.push_back(point(n - i, 0));
    right.push_back(point(n, n - i));
    back.push_back(point(i, n));
    left.push_back(point(0, i));
  }
  faces.insert(faces.end(), {front, right, back, left});
  return make_soup(soup.points, faces);
}

double flat(std::uint32_t, std::uint32_t) { return 0; }

std::set<std::array<double, 3>> normals(const Solid& solid) {
  std::set<std::array<double, 3>> all;
  for (const Plane& p : solid.planes) {
    all.insert({p.normal.x + 0.0, p.normal.y + 0.0, p.normal.z + 0.0});
  }
  return all;
}

TEST(Facets, ACubeHasSixExactPlanes) {
  const Solid solid = import_it(box({0, 0, 0}, {1, 1, 1}));
  expect_sound(solid);
  EXPECT_EQ(solid.facet_count(), 6u);
  EXPECT_EQ(solid.planes.size(), 6u);
  EXPECT_EQ(solid.report.planes_before_merging, 6u);
  EXPECT_EQ(normals(solid),
            (std::set<std::array<double, 3>>{
                {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
  EXPECT_EQ(solid.largest_incidence_gap, 0);
  EXPECT_EQ(solid.report.largest_move, 0);
  for (std::uint32_t f = 0; f < 6; ++f) EXPECT_EQ(solid.vertices_of_facet(f).size(), 4u);
}

TEST(Facets, AFinelyTriangulatedCubeHasSixFacets) {
  for (const double tolerance : {0.0, 1e-12, 1e-6}) {
    const Solid solid = import_it(box_with_gridded_top(8, flat), tolerance);
    expect_sound(solid);
    EXPECT_EQ(solid.facet_count(), 6u);
    EXPECT_EQ(solid.planes.size(), 6u);
    EXPECT_DOUBLE_EQ(solid.volume, 1);
  }
}

TEST(Facets, FacetsInOnePlaneThatDoNotTouchShareIt) {
  const PolygonSoup two = together(box({0, 0, 0}, {1, 1, 1}), box({2, 0, 0}, {3, 1, 1}));
  for (const double tolerance : {0.0, 1e-12}) {
    const Solid solid = import_it(two, tolerance);
    expect_sound(solid);
    EXPECT_EQ(solid.facet_count(), 12u);
    EXPECT_EQ(solid.planes.size(), 8u);  // top, bottom, front, back are shared
  }
}

TEST(Facets, FacetsInOnePlaneThatFaceOppositeWaysDoNotShareIt) {
  // The right of one box and the left of the other lie in x = 1, side by side.
  const Solid solid =
      import_it(together(box({0, 0, 0}, {1, 1, 1}), box({1, 2, 0}, {2, 3, 1})), 1e-9);
  expect_sound(solid);
  EXPECT_EQ(solid.planes.size(), 10u);  // only top and bottom are shared
}

TEST(Facets, TriangleNormalsAreRoundedTheSameWhateverTheTriangle) {
  // A slanted face of a wedge, cut into many triangles of different shapes: one plane, exactly,
  // though its normal (3, 0, 7) / sqrt(58) is not on the grid.
  std::mt19937 random(7);
  std::uniform_int_distribution<int> pick(1, 1023);
  std::vector<glm::dvec2> rim = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<glm::dvec3> points;
  const auto on_plane = [](double x, double y) { return glm::dvec3{7 * x, y, 3 - 3 * x}; };
  for (const glm::dvec2 p : rim) points.push_back(on_plane(p.x, p.y));
  points.push_back({0, 0, 0});  // 4, under point 0
  points.push_back({0, 1, 0});  // 5, under point 3; points 1 and 2 are at height 0
  std::vector<Face> slope = {{0, 1, 2}, {0, 2, 3}};
  for (int i = 0; i < 200; ++i) {
    // A random point of a random triangle, at a multiple of 2^-30 or so in its coordinates.
    const std::size_t t = random() % slope.size();
    const Face face = slope[t];
    const glm::dvec3 a = points[face[0]], b = points[face[1]], c = points[face[2]];
    const double u = pick(random) / 4096.0, v = pick(random) / 4096.0;
    const glm::dvec3 p = a + u * (b - a) + v * (c - a);
    const double x = std::nearbyint(p.x / 7 * 0x1p20) * 0x1p-20;
    const double y = std::nearbyint(p.y * 0x1p20) * 0x1p-20;
    const auto inside = [&](glm::dvec3 from, glm::dvec3 to) {
      return (to.x - from.x) * (y - from.y) - (to.y - from.y) * (7 * x - from.x) > 1e-9;
    };
    if (!inside(a, b) || !inside(b, c) || !inside(c, a)) continue;
    const auto number = static_cast<std::uint32_t>(points.size());
    points.push_back(on_plane(x, y));
    slope[t] = {face[0], face[1], number};
    slope.push_back({face[1], face[2], number});
    slope.push_back({face[2], face[0], number});
  }
  ASSERT_GT(slope.size(), 100u);
  std::vector<Face> faces = slope;
  faces.insert(faces.end(), {{0, 4, 1}, {3, 2, 5}, {0, 3, 5, 4}, {4, 5, 2, 1}});
  const Solid solid = import_it(make_soup(points, faces), 0);
  expect_sound(solid);
  EXPECT_EQ(solid.report.planes_before_merging, 5u);
  EXPECT_EQ(solid.planes.size(), 5u);
  EXPECT_EQ(solid.facet_count(), 5u);
  EXPECT_DOUBLE_EQ(solid.volume, 10.5);
  EXPECT_LT(solid.largest_incidence_gap, 1e-15);
}

TEST(Facets, MergesNoiseWithinTheToleranceOnly) {
  constexpr double kNoise = 1e-9;
  const auto noise = [](std::uint32_t i, std::uint32_t j) {
    return kNoise * std::sin(12.9898 * i + 78.233 * j);
  };
  const PolygonSoup soup = box_with_gridded_top(16, noise);
  const double diagonal = std::sqrt(3.0);
  for (const double tolerance : {0.0, 1e-12, 1e-10}) {
    const Solid rough = import_it(soup, tolerance);
    expect_sound(rough);
    EXPECT_GT(rough.planes.size(), 100u);
    EXPECT_LE(rough.report.largest_move, 2 * tolerance * diagonal);
  }
  const Solid smooth = import_it(soup, 2e-9);
  expect_sound(smooth);
  EXPECT_EQ(smooth.facet_count(), 6u);
  EXPECT_EQ(smooth.planes.size(), 6u);
  EXPECT_GT(smooth.report.planes_before_merging, 100u);
  EXPECT_LE(smooth.report.largest_move, 2 * 2e-9 * diagonal);
  EXPECT_GE(smooth.report.largest_move, kNoise / 2);
  EXPECT_LT(smooth.largest_incidence_gap, 1e-15);
}

TEST(Facets, KeepsEdgesThatAreSharperThanTheTolerance) {
  // A ridge of 1e-3 across the top.
  const auto ridge = [](std::uint32_t, std::uint32_t j) { return j == 4 ? 1e-3 : 0; };
  const Solid solid = import_it(box_with_gridded_top(8, ridge), 1e-4);
  expect_sound(solid);
  EXPECT_GT(solid.planes.size(), 7u);
  EXPECT_LE(solid.report.largest_move, 2e-4 * std::sqrt(3.1));
}

TEST(Facets, TakesASliverIntoTheFaceAroundIt) {
  // A needle of height 1e-13 between the two halves of the top; its normal is along y.
  constexpr double kThin = 1e-13;
  const Solid solid = import_it(make_soup({{0, 0, 0},
                                           {1, 0, 0},
                                           {1, 1, 0},
                                           {0, 1, 0},
                                           {0, 0, 1},
                                           {1, 0, 1},
                                           {1, 1, 1},
                                           {0, 1, 1},
                                           {0.5, 0.5, 1 + kThin}},
                                          {{0, 3, 2, 1},
                                           {0, 1, 5, 4},
                                           {1, 2, 6, 5},
                                           {2, 3, 7, 6},
                                           {3, 0, 4, 7},
                                           {4, 5, 6},
                                           {4, 6, 8},
                                           {4, 8, 7},
                                           {8, 6, 7}}),
                                1e-12);
  expect_sound(solid);
  EXPECT_EQ(solid.facet_count(), 6u);
  EXPECT_EQ(solid.planes.size(), 6u);
}

TEST(Facets, DoesNotTakeTheRimOfAThinPlateIntoItsTop) {
  // A plate thinner than the tolerance: each of its faces keeps its side.
  const Solid plate = import_it(box({0, 0, 0}, {1, 1, 1e-7}), 1e-6);
  expect_sound(plate);
  EXPECT_EQ(plate.planes.size(), 6u);
  EXPECT_EQ(normals(plate).size(), 6u);
}

TEST(Facets, FlattensNoMoreOfALensThanLeavesASolid) {
  // Two flat pyramids, base to base: all of each side is within the tolerance of z = 0.
  constexpr double kFlat = 1e-7;
  const PolygonSoup lens = make_soup(
      {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, kFlat}, {0, 0, -kFlat}},
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
  const Solid solid = import_it(lens, 1e-12);
  expect_sound(solid);
  EXPECT_EQ(solid.planes.size(), 8u);
  const Solid flattened = import_it(lens, 1e-6);
  expect_sound(flattened);
  EXPECT_GE(flattened.planes.size(), 4u);
  EXPECT_LT(flattened.largest_incidence_gap, 1e-15);
}

TEST(Facets, GivesTheSameAnswerEveryTime) {
  const auto noise = [](std::uint32_t i, std::uint32_t j) { return 1e-7 * ((i * 7 + j * 5) % 3); };
  const PolygonSoup soup = box_with_gridded_top(16, noise);
  const Solid a = import_it(soup, 1e-7);
  const Solid b = import_it(soup, 1e-7);
  EXPECT_EQ(a.planes, b.planes);
  EXPECT_EQ(a.facet_plane, b.facet_plane);
  EXPECT_EQ(a.facet_vertices, b.facet_vertices);
}

// The four numbers of the nearest grid plane, by rational arithmetic: |x - q| <= 1/2 for
// x = c / |c|, decided on squares.
bool is_rounded_quotient(std::int64_t q, const boost::multiprecision::cpp_int& numerator,
                         const boost::multiprecision::cpp_int& squared_denominator) {
  using boost::multiprecision::cpp_int;
  const cpp_int twice = 2 * abs(numerator);
  const cpp_int up = 2 * cpp_int(std::abs(q)) + 1;
  const cpp_int down = up - 2;
  if (q != 0 && (q < 0) != (numerator < 0)) return false;
  const bool is_below = twice * twice <= up * up * squared_denominator;
  const bool is_above = q == 0 || twice * twice >= down * down * squared_denominator;
  return is_below && is_above;
}

TEST(NearestPlane, RoundsEveryNumberCorrectly) {
  using boost::multiprecision::cpp_int;
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    // From random triangles to slivers of a few grid steps.
    const std::int64_t size = std::int64_t{1} << (2 + i % 51);
    std::uniform_int_distribution<std::int64_t> offset(-size + 1, size - 1);
    const auto limited = [](std::int64_t x) {
      return std::clamp(x, -(std::int64_t{1} << 52), std::int64_t{1} << 52);
    };
    std::uniform_int_distribution<std::int64_t> anywhere(-(std::int64_t{1} << 52),
                                                         std::int64_t{1} << 52);
    const GridPoint a = {anywhere(random), anywhere(random), anywhere(random)};
    const GridPoint b = {anywhere(random), anywhere(random), anywhere(random)};
    const GridPoint c = {limited(b[0] + offset(random)), limited(b[1] + offset(random)),
                         limited(b[2] + offset(random))};
    const AreaVector area = area_vector(a, b, c);
    if (area == AreaVector{0, 0, 0}) continue;
    const cpp_int x[3] = {cpp_int(area[0]), cpp_int(area[1]), cpp_int(area[2])};
    const cpp_int squared = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    const GridPlane plane = nearest_plane(area, a);
    cpp_int scalar_product = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(is_rounded_quotient(plane.normal[k], x[k] << 52, squared));
      scalar_product += x[k] * a[k];
    }
    EXPECT_TRUE(is_rounded_quotient(plane.offset, scalar_product, squared));
    // Any other corner names the same plane.
    EXPECT_EQ(nearest_plane(area_vector(b, c, a), c), plane);
    EXPECT_TRUE(is_valid(plane.to_plane()));
  }
}

TEST(NearestPlane, KeepsAxes) {
  const std::int64_t one = std::int64_t{1} << 52;
  const GridPlane plane = nearest_plane(area_vector({0, 0, 5}, {3, 0, 5}, {0, 7, 5}), {0, 0, 5});
  EXPECT_EQ(plane.normal, (GridPoint{0, 0, one}));
  EXPECT_EQ(plane.offset, 5);
}

TEST(OffsetAbove, IsTheSmallestThatContains) {
  const Int128 one = Int128{1} << 52;
  EXPECT_EQ(offset_above(5 * one), 5);
  EXPECT_EQ(offset_above(5 * one + 1), 6);
  EXPECT_EQ(offset_above(5 * one - 1), 5);
  EXPECT_EQ(offset_above(-5 * one), -5);
  EXPECT_EQ(offset_above(-5 * one - 1), -5);
  EXPECT_EQ(offset_above(-5 * one + 1), -4);
}

}  // namespace
}  // namespace spoctree
