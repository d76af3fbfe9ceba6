#include "client/lines/arrange_lines.hpp"

#include <gtest/gtest.h>

#include "tests/support/random.hpp"

namespace spoctree {
namespace {

VisibleLine line(Vec3 a, Vec3 b, LineKind kind = LineKind::Crease, bool hidden = false) {
  return {a, b, kind, hidden, false, {}, {}, {}};
}

double ways_between(const VisibleLines& lines, const Camera& camera) {
  double sum = 0;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    sum += glm::distance(camera.project(lines[k - 1].b), camera.project(lines[k].a));
  }
  return sum;
}

TEST(JoinLines, MakesOneLineOfManyWhateverTheirOrderAndDirection) {
  Random random(3);
  VisibleLines lines;
  const Vec3 from{-0.3, 0.7, 0.1};
  const Vec3 step{0.01, -0.02, 0.015};
  for (int k = 0; k < 50; ++k) {
    const Vec3 a = from + static_cast<double>(k) * step;
    lines.push_back(k % 3 == 0 ? line(a + step, a) : line(a, a + step));
  }
  for (std::size_t k = lines.size(); k > 1; --k) {
    std::swap(lines[k - 1], lines[random.below(static_cast<std::uint32_t>(k))]);
  }
  const VisibleLines joined = join_lines(lines, 1e-9);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_NEAR(glm::distance(joined[0].a, joined[0].b), 50 * glm::length(step), 1e-12);
}

TEST(JoinLines, KeepsCornersKindsAndGaps) {
  const VisibleLines lines = {line({0, 0, 0}, {1, 0, 0}),
                              line({1, 0, 0}, {1, 1, 0}),                           // a corner
                              line({1, 0, 0}, {2, 0, 0}, LineKind::Silhouette),     // another kind
                              line({0, 0, 0}, {-1, 0, 0}, LineKind::Crease, true),  // a hidden one
                              line({0, 5, 0}, {1, 5, 0}),
                              line({1 + 1e-6, 5, 0}, {2, 5, 0}),  // a gap
                              line({0, 6, 0}, {1, 6, 0}),
                              line({1, 6, 0}, {2, 6 + 1e-6, 0})};  // a bend
  EXPECT_EQ(join_lines(lines, 1e-9).size(), lines.size());
}

TEST(JoinLines, RemembersWhatALineIsMadeOf) {
  // Three lines along x, the middle one turned, of planes 1, 2, 2 and lengths 1, 2, 1.
  VisibleLines lines = {line({0, 0, 0}, {1, 0, 0}), line({3, 0, 0}, {1, 0, 0}),
                        line({3, 0, 0}, {4, 0, 0})};
  const auto plane = [](std::uint32_t k) { return PlaneRef::of_table(k); };
  lines[0].planes[0] = plane(1);
  for (const int k : {1, 2}) lines[static_cast<std::size_t>(k)].planes[0] = plane(2);
  const VisibleLines joined = join_lines(lines, 1e-9);
  ASSERT_EQ(joined.size(), 1u);
  VisibleLine whole = joined[0].a.x == 0 ? joined[0] : reversed(joined[0]);
  ASSERT_EQ(whole.stretches.size(), 2u);
  EXPECT_NEAR(whole.stretches[0].end, 0.25, 1e-15);
  EXPECT_EQ(whole.stretches[0].planes[0], plane(1));
  EXPECT_EQ(whole.stretches[1].end, 1);
  EXPECT_EQ(whole.stretches[1].planes[0], plane(2));
  EXPECT_EQ(whole.planes[0], plane(2));
}

TEST(JoinLines, GoesStraightThroughACrossing) {
  const VisibleLines lines = {line({0, 0, 0}, {1, 0, 0}), line({0, 0, 0}, {-1, 0, 0}),
                              line({0, 1, 0}, {0, 0, 0}), line({0, -1, 0}, {0, 0, 0})};
  EXPECT_EQ(join_lines(lines, 1e-9).size(), 2u);
}

TEST(JoinLines, FollowsACurveNoFartherThanTheTolerance) {
  // 10000 chords of a circle, each almost straight on: the whole must not become one line.
  VisibleLines lines;
  const auto at = [](int k) {
    const double angle = 1e-4 * k;
    return Vec3{std::cos(angle), std::sin(angle), 0};
  };
  for (int k = 0; k < 10000; ++k) lines.push_back(line(at(k), at(k + 1)));
  for (const VisibleLine& joined : join_lines(lines, 1e-7)) {
    // The middle of a chord of length c is c^2 / 8 off the circle.
    const double chord = glm::distance(joined.a, joined.b);
    EXPECT_LT(chord * chord / 8, 1.1e-7);
  }
}

TEST(RemoveOverlaps, LeavesTheNearestOfLinesThatLieOnEachOther) {
  const Camera camera(Vec3{0, 0, 1});
  const VisibleLines lines = {line({0, 0, -1}, {1, 0, -1}), line({0.25, 0, 0}, {0.5, 0, 0.5})};
  const VisibleLines left = remove_overlaps(lines, camera, 1e-9);
  ASSERT_EQ(left.size(), 3u);
  double length = 0;
  for (const VisibleLine& rest : left) {
    length += glm::distance(camera.project(rest.a), camera.project(rest.b));
  }
  EXPECT_NEAR(length, 1, 1e-9);
}

TEST(RemoveOverlaps, PrefersVisibleLinesToHiddenOnesThatAreNearer) {
  const Camera camera(Vec3{0, 0, 1});
  const VisibleLines lines = {line({0, 0, 1}, {1, 0, 1}, LineKind::Crease, true),
                              line({0, 0, 0}, {1, 0, 0})};
  const VisibleLines left = remove_overlaps(lines, camera, 1e-9);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_FALSE(left[0].hidden);
}

TEST(RemoveOverlaps, KeepsLinesThatCrossTouchOrRunSideBySide) {
  const Camera camera(Vec3{0, 0, 1});
  const VisibleLines lines = {line({0, 0, 0}, {1, 0, 0}), line({0.5, -1, 0}, {0.5, 1, 0.5}),
                              line({1, 0, 0}, {2, 0, 0}), line({0, 1e-6, 0}, {1, 1e-6, 0})};
  EXPECT_EQ(remove_overlaps(lines, camera, 1e-9).size(), lines.size());
  EXPECT_TRUE(remove_overlaps({}, camera, 1e-9).empty());
}

TEST(PenOrder, DrawsAPolygonWithoutLiftingThePen) {
  const Camera camera(Vec3{0, 0, 1});
  VisibleLines lines;
  for (int k = 0; k < 12; ++k) {
    const auto at = [](int i) { return Vec3{std::cos(i * 0.5236), std::sin(i * 0.5236), 0}; };
    const int shuffled = k * 5 % 12;
    lines.push_back(k % 2 == 0 ? line(at(shuffled), at(shuffled + 1))
                               : line(at(shuffled + 1), at(shuffled)));
  }
  EXPECT_LT(ways_between(in_pen_order(lines, camera), camera), 1e-3);
}

TEST(PenOrder, DrawsHiddenLinesThenCreasesThenSilhouettes) {
  const Camera camera(Vec3{0, 0, 1});
  const VisibleLines lines = {line({0, 0, 0}, {1, 0, 0}, LineKind::Silhouette),
                              line({0, 0, 0}, {0, 1, 0}),
                              line({0, 0, 0}, {1, 1, 0}, LineKind::Silhouette, true)};
  const VisibleLines ordered = in_pen_order(lines, camera);
  ASSERT_EQ(ordered.size(), 3u);
  EXPECT_TRUE(ordered[0].hidden);
  EXPECT_EQ(ordered[1].kind, LineKind::Crease);
  EXPECT_EQ(ordered[2].kind, LineKind::Silhouette);
}

TEST(PenOrder, KeepsEveryLineAndMakesShortWays) {
  Random random(11);
  const Camera camera;
  VisibleLines lines;
  double length = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 a{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const Vec3 b = a + 0.05 * Vec3{random.unit(), random.unit(), random.unit()};
    lines.push_back(line(a, b));
    length += glm::distance(a, b);
  }
  const VisibleLines ordered = in_pen_order(lines, camera);
  ASSERT_EQ(ordered.size(), lines.size());
  double ordered_length = 0;
  for (const VisibleLine& one : ordered) ordered_length += glm::distance(one.a, one.b);
  EXPECT_NEAR(ordered_length, length, 1e-9);
  EXPECT_LT(ways_between(ordered, camera), 0.2 * ways_between(lines, camera));
}

}  // namespace
}  // namespace spoctree
