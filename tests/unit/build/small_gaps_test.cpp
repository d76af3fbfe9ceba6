// The size of a tree follows the faces, not the gaps between them: parts with a clearance from wide
// to hardly there, turned out of the axes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "common/base/errors.hpp"
#include "common/tree/classify.hpp"
#include "common/wire/spo_writer.hpp"
#include "server/build/build_octree.hpp"
#include "server/build/certify.hpp"
#include "server/solid/import_solid.hpp"
#include "tests/support/random.hpp"
#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;

constexpr double kGaps[] = {0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

PolygonSoup moved(PolygonSoup soup, glm::dvec3 by) {
  for (glm::dvec3& p : soup.points) p += by;
  return soup;
}

Solid turned(PolygonSoup soup) {
  for (glm::dvec3& p : soup.points) {
    p = {p.x + 0.3 * p.z - 0.1 * p.y, p.y - 0.2 * p.z + 0.15 * p.x, p.z + 0.1 * p.x};
  }
  return import_solid(soup, "parts", {.flat_tolerance = 0});
}

std::vector<glm::dvec2> arc(double radius, int sides, double from, double to) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i <= sides; ++i) {
    const double angle = std::numbers::pi * (from + (to - from) * i / sides);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

/// Two boxes, one beside a part of the other's side.
PolygonSoup boxes(double gap) {
  return together(box({0, 0, 0}, {10, 10, 10}), box({10 + gap, 3, 2}, {20, 8, 15}));
}

/// A stack of thin plates.
PolygonSoup plates(double gap) {
  PolygonSoup stack = box({0, 0, 0}, {10, 8, 0.5});
  for (int i = 1; i < 8; ++i) {
    const double bottom = 0.6 * i - 0.1 + gap;
    stack = together(stack, box({0, 0, bottom}, {10, 8, 0.6 * i + 0.5}));
  }
  return stack;
}

/// A pin of many sides in a half bearing.
PolygonSoup pin_in_bearing(double gap, int sides) {
  std::vector<glm::dvec2> bearing = arc(2, sides, 0, 1);
  const std::vector<glm::dvec2> inner = arc(1 + gap, sides, 1, 0);
  bearing.insert(bearing.end(), inner.begin(), inner.end());
  std::vector<glm::dvec2> pin = arc(1, 2 * sides, 0, 2);
  pin.pop_back();
  return together(prism(bearing, 1), moved(prism(pin, 1.5), {0, 0, -0.25}));
}

/// Two pyramids, tip to tip.
PolygonSoup tips(double gap) {
  PolygonSoup pyramid = make_soup({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}, {0, 0, 5}},
                                  {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  PolygonSoup other = pyramid;
  for (glm::dvec3& p : other.points) p.z = 10 + gap - p.z;
  return together(pyramid, reversed(other));
}

Octree tree_of(const Solid& solid) {
  const SolidQueries queries(solid);
  BuiltOctree built = build_octree(solid, queries, {});
  certify(built, solid, queries);
  return std::move(built.tree);
}

template <class Parts>
void expect_size_follows_faces(const Parts& parts) {
  const std::size_t widest = encode_spo(tree_of(turned(parts(kGaps[0]))), {}).size();
  for (const double gap : kGaps) {
    const Solid solid = turned(parts(gap));
    const Octree tree = tree_of(solid);
    EXPECT_LE(encode_spo(tree, {}).size(), widest * 3 / 2) << "gap " << gap;
    EXPECT_NEAR(tree.levels.back().statement.inner_volume, solid.volume, 1e-9 * solid.volume);
  }
}

TEST(SmallGaps, DoNotMakeTreesOfBoxesLarger) { expect_size_follows_faces(boxes); }
TEST(SmallGaps, DoNotMakeTreesOfPlatesLarger) { expect_size_follows_faces(plates); }
TEST(SmallGaps, DoNotMakeTreesOfTipsLarger) { expect_size_follows_faces(tips); }
TEST(SmallGaps, DoNotMakeTreesOfRoundFitsLarger) {
  for (const int sides : {3, 8, 30}) {
    SCOPED_TRACE(sides);
    expect_size_follows_faces([&](double gap) { return pin_in_bearing(gap, sides); });
  }
}

/// Walls so close that rounded planes cannot tell which comes first, one of them larger.
TEST(SmallGaps, OfAsMuchAsRoundingLeaveMaterialOnBothSides) {
  std::size_t built = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const double gap = std::pow(10.0, random.between(-16.5, -11));
    PolygonSoup soup = together(box({0, 0, 0}, {1, 1, 1}), box({1 + gap, 0.25, 0}, {2, 0.75, 1}));
    const double angle = random.between(0, 7);
    const double tilt = random.between(0, 7);
    const auto turn = [&](glm::dvec3 p) {
      p = {std::cos(angle) * p.x - std::sin(angle) * p.y,
           std::sin(angle) * p.x + std::cos(angle) * p.y, p.z};
      return glm::dvec3{p.x, std::cos(tilt) * p.y - std::sin(tilt) * p.z,
                        std::sin(tilt) * p.y + std::cos(tilt) * p.z};
    };
    for (glm::dvec3& p : soup.points) p = turn(p);
    std::optional<Solid> solid;
    try {
      solid = import_solid(soup, "boxes", {.flat_tolerance = 0});
    } catch (const BadInput&) {
      continue;  // once rounded, they overlap
    }
    ++built;
    const Octree tree = tree_of(*solid);
    const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
    for (int i = 0; i < 100; ++i) {
      const glm::dvec3 p{random.between(-0.2, 2.2), random.between(-0.2, 1.2),
                         random.between(-0.2, 1.2)};
      const auto between = [](double x, double lower, double upper) {
        return lower < x && x < upper;
      };
      const bool is_in = between(p.z, 0, 1) && ((between(p.x, 0, 1) && between(p.y, 0, 1)) ||
                                                (between(p.x, 1, 2) && between(p.y, 0.25, 0.75)));
      EXPECT_EQ(classify_point(tree, tree.universe.to_universe(turn(p)), last),
                is_in ? PointClass::In : PointClass::Out)
          << "seed " << seed << ", gap " << gap;
    }
  }
  EXPECT_GT(built, 100u);
}

}  // namespace
}  // namespace spoctree
