// What merging makes of faces that are flat up to noise: which planes come out, how far corners
// move, and what stays as it was because it would not be a solid any more.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <map>
#include <numbers>
#include <set>

#include "server/mesh/parse_off.hpp"
#include "server/solid/self_intersections.hpp"
#include "server/solid/settle_corner.hpp"
#include "server/solid/solid_queries.hpp"
#include "server/solid/write_off.hpp"
#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;

// Corners are within a few steps of the grid of their planes.
constexpr double kGridGap = 0x1p-48;

double diagonal_of(const PolygonSoup& soup) {
  glm::dvec3 lower = soup.points[0];
  glm::dvec3 upper = lower;
  for (const glm::dvec3 p : soup.points) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  return glm::distance(lower, upper);
}

void round_to_float(PolygonSoup& soup) {
  for (glm::dvec3& p : soup.points) {
    for (int i = 0; i < 3; ++i) p[i] = static_cast<double>(static_cast<float>(p[i]));
  }
}

// Turns by angles with nothing special about them and moves off the origin.
void turn(PolygonSoup& soup) {
  const glm::dvec3 x = glm::normalize(glm::dvec3{0.6, 0.37, -0.2});
  const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3{0.1, 0.9, 0.4}, x));
  const glm::dmat3 rotation(x, y, glm::cross(x, y));
  for (glm::dvec3& p : soup.points) p = rotation * p + glm::dvec3{0.3, -1.7, 2.1};
}

// The surface of a box of n x n x n cells, two triangles to each square.
PolygonSoup gridded_box(int n, glm::dvec3 size) {
  std::map<std::array<int, 3>, std::uint32_t> number;
  std::vector<glm::dvec3> points;
  std::vector<Face> faces;
  const auto point = [&](std::array<int, 3> at) {
    const auto [entry, is_new] = number.insert({at, static_cast<std::uint32_t>(points.size())});
    if (is_new) points.push_back(size * glm::dvec3(at[0], at[1], at[2]) / static_cast<double>(n));
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int wall : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          std::array<std::array<int, 3>, 4> corners{};
          for (std::size_t k = 0; k < 4; ++k) {
            corners[k][axis] = wall;
            corners[k][(axis + 1) % 3] = i + (k == 1 || k == 2);
            corners[k][(axis + 2) % 3] = j + (k >= 2);
          }
          if (wall == 0) std::swap(corners[1], corners[3]);
          const std::uint32_t a = point(corners[0]), b = point(corners[1]);
          const std::uint32_t c = point(corners[2]), d = point(corners[3]);
          faces.push_back({a, b, c});
          faces.push_back({a, c, d});
        }
      }
    }
  }
  return make_soup(points, faces);
}

// A sphere of trapezoids, each cut into two triangles, with triangles at the poles: four planes
// meet in nearly every corner.
PolygonSoup sphere_of_trapezoids(std::uint32_t slices, std::uint32_t stacks) {
  std::vector<glm::dvec3> points = {{0, 0, -1}, {0, 0, 1}};
  for (std::uint32_t j = 1; j < stacks; ++j) {
    for (std::uint32_t i = 0; i < slices; ++i) {
      const double height = std::numbers::pi * j / stacks;
      const double around = 2 * std::numbers::pi * i / slices;
      points.emplace_back(std::sin(height) * std::cos(around), std::sin(height) * std::sin(around),
                          -std::cos(height));
    }
  }
  std::vector<Face> faces;
  const auto point = [&](std::uint32_t i, std::uint32_t j) {
    return 2 + (j - 1) * slices + i % slices;
  };
  for (std::uint32_t i = 0; i < slices; ++i) {
    faces.push_back({0, point(i + 1, 1), point(i, 1)});
    faces.push_back({1, point(i, stacks - 1), point(i + 1, stacks - 1)});
    for (std::uint32_t j = 1; j + 1 < stacks; ++j) {
      faces.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
      faces.push_back({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  }
  return make_soup(points, faces);
}

PolygonSoup soup_of(const Solid& solid) { return parse_off(to_off(solid), "it"); }

void expect_merged_well(const Solid& merged, const PolygonSoup& soup, double tolerance) {
  expect_sound(merged);
  EXPECT_LE(merged.largest_incidence_gap, kGridGap);
  EXPECT_LT(merged.report.largest_move, 2 * tolerance * diagonal_of(soup));
  EXPECT_LE(merged.planes.size(), merged.report.planes_before_merging);
}

TEST(MergeFaces, FindsTheSixPlanesOfATurnedBoxInSinglePrecision) {
  PolygonSoup soup = gridded_box(12, {3, 2, 1});
  turn(soup);
  round_to_float(soup);
  const Solid rough = import_it(soup, 0);
  expect_sound(rough);
  EXPECT_GT(rough.planes.size(), 1000u);
  EXPECT_EQ(rough.report.largest_move, 0);
  const Solid merged = import_it(soup, 1e-6);
  expect_merged_well(merged, soup, 1e-6);
  EXPECT_EQ(merged.planes.size(), 6u);
  EXPECT_EQ(merged.facet_count(), 6u);
  EXPECT_NEAR(merged.volume, 6, 6e-6);
  // Single precision is off by 2^-24 of numbers below 4, at most.
  EXPECT_LT(merged.report.largest_move, 3 * 0x1p-23);
}

TEST(MergeFaces, LetsFourPlanesMeetInOneCorner) {
  PolygonSoup soup = sphere_of_trapezoids(24, 12);
  turn(soup);
  round_to_float(soup);
  EXPECT_EQ(import_it(soup, 0).planes.size(), 2u * 24 * 11);
  const Solid merged = import_it(soup, 1e-6);
  expect_merged_well(merged, soup, 1e-6);
  EXPECT_EQ(merged.planes.size(), 24u * 12);
  EXPECT_EQ(merged.facet_count(), 24u * 12);
}

TEST(MergeFaces, ToleranceZeroMovesNothing) {
  PolygonSoup soup = gridded_box(4, {1, 1, 1});
  turn(soup);
  round_to_float(soup);
  const Solid solid = import_it(soup, 0);
  EXPECT_EQ(solid.report.largest_move, 0);
  EXPECT_EQ(solid.planes.size(), solid.report.planes_before_merging);
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    EXPECT_EQ(solid.vertices[v], solid.universe.to_grid(soup.points[v]));
  }
}

TEST(MergeFaces, LeavesWhatIsFlatAlreadyWhereItIs) {
  // The box's own planes are exact, all corners stay where they are.
  const PolygonSoup soup = gridded_box(6, {1, 1, 1});
  const Solid solid = import_it(soup, 1e-6);
  expect_merged_well(solid, soup, 1e-6);
  EXPECT_EQ(solid.planes.size(), 6u);
  EXPECT_EQ(solid.report.largest_move, 0);
}

// Two cones over a regular polygon, as many faces each as it has sides.
PolygonSoup bipyramid(std::uint32_t sides) {
  std::vector<glm::dvec3> points;
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    faces.push_back({i, (i + 1) % sides, sides});
    faces.push_back({(i + 1) % sides, i, sides + 1});
  }
  points.push_back({0, 0, 1});
  points.push_back({0, 0, -1});
  return make_soup(points, faces);
}

// Quadrilaterals between circles of latitude, flat but for rounding, and triangles at the poles.
PolygonSoup globe(std::uint32_t rows) {
  const std::uint32_t columns = 2 * rows;
  std::vector<glm::dvec3> points;
  std::vector<Face> faces;
  for (std::uint32_t row = 1; row < rows; ++row) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const double latitude = std::numbers::pi * row / rows;
      const double longitude = 2 * std::numbers::pi * i / columns;
      points.push_back({std::sin(latitude) * std::cos(longitude),
                        std::sin(latitude) * std::sin(longitude), -std::cos(latitude)});
    }
  }
  const auto south = static_cast<std::uint32_t>(points.size());
  points.push_back({0, 0, -1});
  points.push_back({0, 0, 1});
  for (std::uint32_t i = 0; i < columns; ++i) {
    const std::uint32_t next = (i + 1) % columns;
    const std::uint32_t last = (rows - 2) * columns;
    faces.push_back({next, i, south});
    faces.push_back({last + i, last + next, south + 1});
    for (std::uint32_t row = 0; row + 2 < rows; ++row) {
      const std::uint32_t at = row * columns;
      faces.push_back({at + i, at + next, at + columns + next, at + columns + i});
    }
  }
  return make_soup(points, faces);
}

// A torus of quadrilaterals in single precision, each cut into two triangles. No two of the
// quadrilaterals lie in one plane.
PolygonSoup cut_torus(std::uint32_t n) {
  const std::uint32_t m = n / 2;
  std::vector<glm::dvec3> points;
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const double a = 2 * std::numbers::pi * i / n;
      const double b = 2 * std::numbers::pi * j / m;
      points.push_back({(10 + 3 * std::cos(b)) * std::cos(a), (10 + 3 * std::cos(b)) * std::sin(a),
                        3 * std::sin(b)});
      const std::uint32_t k = (i + 1) % n;
      const std::uint32_t l = (j + 1) % m;
      faces.push_back({i * m + j, k * m + j, k * m + l});
      faces.push_back({i * m + j, k * m + l, i * m + l});
    }
  }
  PolygonSoup soup = make_soup(points, faces);
  round_to_float(soup);
  return soup;
}

// All planes hang together: four meet in every corner.
TEST(MergeFaces, FindsEveryQuadrilateralOfATorusInSinglePrecision) {
  for (const std::uint32_t n : {24u, 40u, 56u}) {
    const PolygonSoup soup = cut_torus(n);
    const Solid solid = import_it(soup, 1e-6);
    expect_merged_well(solid, soup, 1e-6);
    EXPECT_EQ(solid.planes.size(), n * n / 2);
    expect_sound(solid);
  }
}

// Where faces of a fan are flat two by two, their planes do not meet at its tip any more, and next
// to nothing could be saved by moving all other corners.
TEST(MergeFaces, LeavesAFanAlone) {
  const PolygonSoup fan = bipyramid(400);
  const Solid solid = import_it(fan, 5e-5);
  EXPECT_EQ(solid.planes.size(), 800u);
  EXPECT_EQ(solid.report.largest_move, 0);
  expect_sound(solid);
}

TEST(MergeFaces, NeverEndsWithMorePlanes) {
  // A merged cap at a pole must not break the faces around it.
  const PolygonSoup ball = globe(40);
  for (const double tolerance : {1e-12, 1e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3}) {
    SCOPED_TRACE(tolerance);
    const Solid solid = import_it(ball, tolerance);
    EXPECT_LE(solid.planes.size(), 40u * 80u);
    expect_sound(solid);
  }
  for (const double tolerance : {1e-6, 1e-5, 1e-4, 1e-3}) {
    SCOPED_TRACE(tolerance);
    EXPECT_LE(import_it(bipyramid(400), tolerance).planes.size(), 800u);
  }
}

TEST(MergeFaces, MergedOnceMoreNothingChanges) {
  for (PolygonSoup soup : {gridded_box(6, {3, 2, 1}), sphere_of_trapezoids(16, 8)}) {
    turn(soup);
    round_to_float(soup);
    const Solid merged = import_it(soup, 1e-6);
    const PolygonSoup again = soup_of(merged);
    const Solid twice = import_it(again, 1e-6);
    expect_merged_well(twice, again, 1e-6);
    EXPECT_EQ(twice.planes.size(), merged.planes.size());
    // But for the rounding of doubles in the file between.
    EXPECT_LT(twice.report.largest_move, 1e-13);
  }
}

TEST(MergeFaces, PointsFartherThanTwiceTheToleranceKeepTheirSide) {
  constexpr double kTolerance = 1e-4;
  PolygonSoup soup = sphere_of_trapezoids(20, 10);
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    soup.points[i] *= 1 + 0.5 * kTolerance * std::sin(12.9898 * static_cast<double>(i));
  }
  const Solid before = import_it(soup, 0);
  const Solid after = import_it(soup, kTolerance);
  expect_merged_well(after, soup, kTolerance);
  EXPECT_LT(after.planes.size(), before.planes.size());
  const SolidQueries then(before);
  const SolidQueries now(after);
  const double step = 2.001 * kTolerance * diagonal_of(soup) / before.universe.scale();
  for (const SolidTriangle& t : before.triangles) {
    const Vec3 a = before.vertices[t.vertex[0]];
    const Vec3 b = before.vertices[t.vertex[1]];
    const Vec3 c = before.vertices[t.vertex[2]];
    const Vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (const Vec3 p : {a, 0.5 * (a + b), (a + b + c) / 3.0}) {
      for (const double off : {step, -step}) {
        const Vec3 point = p + off * normal;
        if (then.distance(point) < 0.9999 * step) continue;
        EXPECT_EQ(now.side_of(point), then.side_of(point));
      }
    }
  }
}

// A box with many points along the front edge of its top, which bulges: along it the top has
// needles, and the front a fan of triangles that are not quite in one plane.
PolygonSoup box_with_needles(double bulge) {
  constexpr std::uint32_t kPoints = 40;
  std::vector<glm::dvec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const auto first = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 1; i < kPoints; ++i) {
    const double x = static_cast<double>(i) / kPoints;
    points.emplace_back(x, -bulge * x * (1 - x), 1);
  }
  const std::uint32_t last = first + kPoints - 2;
  std::vector<Face> faces = {{0, 3, 2, 1}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const auto at = [&](std::uint32_t i) {
    return i == 0 ? 4u : (i == kPoints ? 5u : first + i - 1);
  };
  for (std::uint32_t i = 0; i < kPoints; ++i) faces.push_back({0, at(i + 1), at(i)});
  faces.push_back({0, 1, 5});
  for (std::uint32_t i = 1; i + 1 < kPoints; ++i) faces.push_back({4, at(i), at(i + 1)});
  faces.push_back({4, last, 5});
  faces.push_back({4, 5, 6});
  faces.push_back({4, 6, 7});
  return make_soup(points, faces);
}

TEST(MergeFaces, TurnsEdgesWhereNeedlesCollapse) {
  const PolygonSoup soup = box_with_needles(1e-8);
  const Solid merged = import_it(soup, 1e-6);
  expect_merged_well(merged, soup, 1e-6);
  EXPECT_EQ(merged.planes.size(), 6u);
}

TEST(MergeFaces, ASolidThinnerThanTheToleranceStaysASolid) {
  for (const double thickness : {1e-5, 1e-6, 3e-7, 1e-8, 1e-11}) {
    PolygonSoup soup = gridded_box(4, {1, 1, thickness});
    const Solid flat = import_it(soup, 1e-6);
    expect_merged_well(flat, soup, 1e-6);
    EXPECT_EQ(flat.planes.size(), 6u);
    for (std::size_t i = 0; i < soup.points.size(); ++i) {
      soup.points[i].z += 0.1 * thickness * std::sin(12.9898 * static_cast<double>(i));
    }
    turn(soup);
    const Solid uneven = import_it(soup, 1e-6);
    expect_merged_well(uneven, soup, 1e-6);
  }
}

TEST(MergeFaces, NeverRefusesASolid) {
  // Noise as large as the cells and larger tolerances: much of what could be merged must not be.
  for (int seed = 0; seed < 12; ++seed) {
    PolygonSoup soup = gridded_box(5, {1, 0.7, 0.4});
    for (std::size_t i = 0; i < soup.points.size(); ++i) {
      const auto k = static_cast<double>(i + 1000 * static_cast<std::size_t>(seed));
      soup.points[i] +=
          0.02 * glm::dvec3(std::sin(12.9898 * k), std::sin(78.233 * k), std::sin(39.425 * k));
    }
    ASSERT_EQ(import_error(soup, 0), "");
    for (const double tolerance : {1e-4, 1e-3, 1e-2, 0.03, 0.09}) {
      const Solid merged = import_it(soup, tolerance);
      expect_merged_well(merged, soup, tolerance);
    }
  }
}

TEST(MergeFaces, DoesTheSameWithAnyNumberOfThreads) {
  PolygonSoup soup = sphere_of_trapezoids(60, 30);
  turn(soup);
  round_to_float(soup);
  std::string one;
  for (const std::size_t threads : {1, 2, 5}) {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                            threads);
    const Solid solid = import_it(soup, 1e-6);
    const std::string text = to_off(solid);
    if (one.empty()) one = text;
    EXPECT_TRUE(text == one) << threads << " threads";
  }
}

// Two fans over a wavy ring of n points.
PolygonSoup two_fans(std::uint32_t n, double twist) {
  std::vector<glm::dvec3> points = {{0, 0, 1}, {0, 0, -1}};
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double at = 2 * std::numbers::pi * i / n;
    const double around = at + twist * std::sin(5 * at);
    points.emplace_back(std::cos(around), std::sin(around), 0.01 * std::sin(7 * at));
    faces.push_back({0, 2 + i, 2 + (i + 1) % n});
    faces.push_back({1, 2 + (i + 1) % n, 2 + i});
  }
  return make_soup(points, faces);
}

TEST(LargeFans, AreSolids) {
  const PolygonSoup soup = two_fans(20000, 0);
  const Solid solid = import_it(soup, 0);
  EXPECT_EQ(solid.planes.size(), 40000u);
  EXPECT_LE(import_it(soup, 1e-6).planes.size(), 40000u);
}

TEST(LargeFans, MeetWhereEachTwoTrianglesSay) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  // A ball of two fans, another one stuck through its side, and a loose triangle through both.
  std::vector<Vec3> points;
  std::vector<Corners> triangles;
  const auto add_fans = [&](Vec3 centre, std::uint32_t n) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.push_back(centre + Vec3{0, 0, 0.2});
    points.push_back(centre - Vec3{0, 0, 0.2});
    for (std::uint32_t i = 0; i < n; ++i) {
      const double at = 2 * std::numbers::pi * i / n;
      points.push_back(centre + 0.3 * Vec3{std::cos(at), std::sin(at), 0.1 * std::sin(7 * at)});
      const std::uint32_t here = first + 2 + i;
      const std::uint32_t next = first + 2 + (i + 1) % n;
      triangles.push_back({first, here, next});
      triangles.push_back({first + 1, next, here});
    }
  };
  add_fans({0.1, 0, 0}, 400);
  add_fans({-0.15, 0.05, 0.07}, 300);
  const auto first = static_cast<std::uint32_t>(points.size());
  points.insert(points.end(), {{0.4, -0.4, 0.01}, {-0.5, 0.4, -0.02}, {-0.4, 0.5, 0.03}});
  triangles.push_back({first, first + 1, first + 2});

  std::set<std::array<std::uint32_t, 2>> expected;
  std::vector<CGAL::Triangle_3<Kernel>> exact;
  for (const Corners& t : triangles) {
    const auto point = [&](std::uint32_t i) {
      return Kernel::Point_3(points[i].x, points[i].y, points[i].z);
    };
    exact.emplace_back(point(t[0]), point(t[1]), point(t[2]));
  }
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (std::uint32_t j = i + 1; j < triangles.size(); ++j) {
      const bool share_a_corner =
          std::find_first_of(triangles[i].begin(), triangles[i].end(), triangles[j].begin(),
                             triangles[j].end()) != triangles[i].end();
      if (!share_a_corner && CGAL::do_intersect(exact[i], exact[j])) expected.insert({i, j});
    }
  }
  EXPECT_GT(expected.size(), 500u);
  const MeetingTriangles meeting =
      find_meeting_triangles(points, triangles, box_tree_of(points, triangles));
  EXPECT_TRUE(meeting.are_all);
  EXPECT_EQ(meeting.pairs.size(), expected.size());
  for (const auto& pair : meeting.pairs) EXPECT_TRUE(expected.contains(pair));
}

TEST(LargeFans, AreRefusedWhereTheyFoldBack) {
  // Twisted so that the ring runs backwards for a while, at other heights.
  EXPECT_NE(import_error(two_fans(1000, 0.1), 0).rfind("it: self-intersecting: ", 0), 0u);
  EXPECT_EQ(import_error(two_fans(1000, 0.5), 0).rfind("it: self-intersecting: ", 0), 0u);
}

CornerPlane plane(double x, double y, double z, double height) {
  CornerPlane made;
  const long double length = std::sqrt(static_cast<long double>(x * x + y * y + z * z));
  made.normal = {x / length, y / length, z / length};
  made.height = height;
  return made;
}

TEST(SettleCorner, TakesTheShortestWayToAllPlanes) {
  std::vector<CornerPlane> planes = {plane(1, 0, 0, 1e-6)};
  auto way = settle_corner(planes, 1e-3L);
  EXPECT_EQ(way, (std::array<long double, 3>{1e-6, 0, 0}));
  planes = {plane(1, 0, 0, 1e-6), plane(1, 1, 0, 0), plane(0, 0, 1, -2e-6)};
  way = settle_corner(planes, 1e-3L);
  EXPECT_NEAR(static_cast<double>(way[0]), 1e-6, 1e-20);
  EXPECT_NEAR(static_cast<double>(way[1]), -1e-6, 1e-20);
  EXPECT_NEAR(static_cast<double>(way[2]), -2e-6, 1e-20);
  for (const CornerPlane& p : planes) EXPECT_TRUE(p.is_reached);
}

TEST(SettleCorner, LeavesOutPlanesThatAreTooFarOrTooMany) {
  // Nearly parallel, and 1e-6 apart: they meet 1e-2 away.
  std::vector<CornerPlane> planes = {plane(0, 0, 1, 0), plane(1e-4, 0, 1, 1e-6)};
  auto way = settle_corner(planes, 1e-5L);
  EXPECT_EQ(way, (std::array<long double, 3>{0, 0, 0}));
  EXPECT_TRUE(planes[0].is_reached);
  EXPECT_FALSE(planes[1].is_reached);
  // A fourth plane passes beside the point of the first three, a fifth through it.
  planes = {plane(1, 0, 0, 1e-6), plane(0, 1, 0, 0), plane(0, 0, 1, 0), plane(1, 1, 1, 0),
            plane(0, 1, 1, 0)};
  way = settle_corner(planes, 1e-5L);
  EXPECT_NEAR(static_cast<double>(way[0]), 1e-6, 1e-20);
  EXPECT_FALSE(planes[3].is_reached);
  EXPECT_TRUE(planes[4].is_reached);
}

}  // namespace
}  // namespace spoctree
