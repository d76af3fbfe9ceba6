// Expressions of cells against the solid, point by point.
#include "server/build/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <set>

#include "common/geometry/predicates.hpp"
#include "common/tree/validate.hpp"
#include "server/solid/import_solid.hpp"
#include "server/solid/solid_queries.hpp"
#include "tests/unit/build/cells.hpp"

namespace spoctree {
namespace {

/// Reads an expression the plain way; moves `token` behind it.
bool value_of(const Expression& expression, std::size_t& token, const Solid& solid, Vec3 point) {
  const std::uint32_t here = expression.tokens.at(token++);
  if (here < kFirstPlaneToken) return here == kInToken;
  const Plane& plane = solid.planes[expression.planes.at(here - kFirstPlaneToken)];
  const bool inside = value_of(expression, token, solid, point);
  const bool outside = value_of(expression, token, solid, point);
  return side_of_any_point(plane, point) <= 0 ? inside : outside;
}

/// `is_inside` gives nothing for points that are too near to the boundary to tell.
template <class IsInside>
void judge(const Solid& solid, std::uint32_t depth, std::size_t points, Random& random,
           IsInside is_inside) {
  const Incidence incidence(solid);
  std::size_t wrong = 0;
  for (const Cell& cell : cells_of(solid, incidence, depth)) {
    if (cell.boundary.fragments.empty()) continue;
    const Expression expression =
        ExpressionBuilder(solid, incidence).build(cell.boundary, cell.boundary.fragments);
    ASSERT_TRUE(
        is_well_formed(expression.tokens, static_cast<std::uint32_t>(expression.planes.size())));
    const std::set<std::uint32_t> distinct(expression.planes.begin(), expression.planes.end());
    ASSERT_EQ(distinct.size(), expression.planes.size());
    const Vec3 lower = cell.corner_position(solid, 0);
    const Vec3 upper = cell.corner_position(solid, 7);
    for (std::size_t i = 0; i < points; ++i) {
      Vec3 point;
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] = random.between(lower[axis], upper[axis]);
      }
      if (random.chance(0.5)) {  // near the boundary
        const auto& corners = cell.boundary.corners;
        const Vec3 a = corners[random.below(static_cast<std::uint32_t>(corners.size()))].position;
        const Vec3 b = corners[random.below(static_cast<std::uint32_t>(corners.size()))].position;
        const double off = std::pow(10, random.between(-6, -2));
        point = glm::mix(glm::mix(a, b, random.unit()), point, off);
      }
      const auto expected = is_inside(point);
      if (!expected) continue;
      std::size_t token = 0;
      wrong += value_of(expression, token, solid, point) != *expected;
    }
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(Expression, SaysWhatTheHeightFieldSays) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const HeightField field = random_height_field(4, Vec3(-1), 0.5, -0.75, 0.125, 13, random);
    const Solid solid = height_field_solid(field);
    for (const std::uint32_t depth : {0u, 1u, 2u}) {
      judge(solid, depth, 200, random, [&](Vec3 p) { return field.is_inside(p); });
    }
  }
}

TEST(Expression, SaysWhatTheVoxelsSay) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const Voxels voxels = random_voxels(2, random);
    const auto is_inside = [&](Vec3 p) -> std::optional<bool> {
      const Vec3 cell = (p + 1.0) * 2.0;
      const Vec3 off = glm::abs(cell - glm::round(cell));
      if (std::min({off.x, off.y, off.z}) < 1e-12) return std::nullopt;
      return voxels(static_cast<int>(std::floor(cell.x)), static_cast<int>(std::floor(cell.y)),
                    static_cast<int>(std::floor(cell.z)));
    };
    for (const std::uint32_t depth : {0u, 1u, 2u}) {
      judge(voxel_solid(voxels), depth, 200, random, is_inside);
    }
  }
}

TEST(Expression, SaysWhatTheSolidSaysWhereNothingIsSimple) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const Solid solid = uneven_solid(4, random);
    const SolidQueries queries(solid);
    const auto is_inside = [&](Vec3 p) -> std::optional<bool> {
      if (queries.distance(p) < 1e-13) return std::nullopt;
      return queries.side_of(p) == SolidQueries::Side::In;
    };
    for (const std::uint32_t depth : {0u, 1u, 2u}) judge(solid, depth, 100, random, is_inside);
  }
}

// What scans of flat parts have: fans of triangles that are coplanar up to the last bits, so that
// their planes, rounded, meet anywhere.
TEST(Expression, IsNotLedAstrayByFacesThatAreNearlyInOnePlane) {
  for (const int bits : {20, 30, 36, 40, 44, 47, 49, 50, 51}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      SCOPED_TRACE(bits);
      Random random(seed);
      const HeightField field = random_height_field(4, Vec3(-0.8125), 0.40625, 0.28125,
                                                    std::ldexp(1.0, -bits), 4, random);
      const Solid solid = height_field_solid(field);
      const SolidQueries queries(solid);
      const auto is_inside = [&](Vec3 p) -> std::optional<bool> {
        if (queries.distance(p) < 1e-13) return std::nullopt;
        return field.is_inside(p);
      };
      for (const std::uint32_t depth : {0u, 1u, 2u}) judge(solid, depth, 100, random, is_inside);
    }
  }
}

// Two fans of n triangles over a wavy ring, one of them dented or both. `dents` of the ring's waves
// are so deep that planes of faces have much on both sides, 0: nearly all have all on one.
Solid fans(std::uint32_t n, double tip, double dents, double noise, Random& random) {
  PolygonSoup soup;
  soup.points = {{0, 0, tip}, {0, 0, -1}};
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    soup.corners.insert(soup.corners.end(), {a, b, c});
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    const double at = 2 * std::numbers::pi * i / n;
    const double radius = 1 + dents * std::sin(9 * at);
    soup.points.emplace_back(radius * std::cos(at), radius * std::sin(at),
                             0.4 + dents * std::sin(5 * at) + noise * random.between(-1, 1));
    add(0, 2 + i, 2 + (i + 1) % n);
    add(1, 2 + (i + 1) % n, 2 + i);
  }
  ImportOptions options;
  options.flat_tolerance = 0;
  return import_solid(soup, "fans", options);
}

// So many faces around one vertex are not split one by one.
TEST(Expression, SaysWhatTheSolidSaysAroundAVertexOfManyFaces) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double tip = seed % 2 == 0 ? 0.1 : 0.9;
    const double dents = seed % 3 == 0 ? 0 : 0.1;
    const double noise = seed % 4 < 2 ? 0 : std::pow(10, -3.0 - static_cast<double>(seed % 5) * 3);
    const Solid solid = fans(300, tip, dents, noise, random);
    const SolidQueries queries(solid);
    const auto is_inside = [&](Vec3 p) -> std::optional<bool> {
      if (queries.distance(p) < 1e-13) return std::nullopt;
      return queries.side_of(p) == SolidQueries::Side::In;
    };
    for (const std::uint32_t depth : {0u, 1u}) judge(solid, depth, 200, random, is_inside);
  }
}

}  // namespace
}  // namespace spoctree
