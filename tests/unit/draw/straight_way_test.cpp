#include "client/draw/straight_way.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace spoctree {
namespace {

constexpr double kTolerance = 1e-3;

TEST(StraightWay, GoesOnWherePointsLieOnALineUpToTheTolerance) {
  StraightWay way({0, 0}, {1, 0}, kTolerance);
  EXPECT_TRUE(way.go_on_to({2, 0.9e-3}));
  EXPECT_TRUE(way.go_on_to({50, 0}));
  EXPECT_FALSE(way.go_on_to({51, 1}));
}

TEST(StraightWay, EndsWhereItTurnsBack) {
  StraightWay way({1, 1}, {3, 3}, kTolerance);
  EXPECT_FALSE(way.go_on_to({2, 2}));
  EXPECT_FALSE(way.go_on_to({3, 3}));
  EXPECT_TRUE(way.go_on_to({3.001, 3.001}));
}

TEST(StraightWay, KeepsAllPointsOfAFineArcWithinTheTolerance) {
  // Each corner of this arc stands off the line between its neighbours by 1e-6 only.
  const double radius = 50;
  const double angle = std::sqrt(8e-6 / radius) / 2;
  const auto at = [&](int k) { return radius * Vec2{std::cos(k * angle), std::sin(k * angle)}; };
  int begin = 0;
  StraightWay way(at(0), at(1), kTolerance);
  int longest = 0;
  for (int k = 2; k < 2000; ++k) {
    if (way.go_on_to(at(k))) continue;
    // What went straight until k - 1 is a chord: its sagitta.
    const double sagitta = radius * (1 - std::cos((k - 1 - begin) * angle / 2));
    EXPECT_LE(sagitta, kTolerance * 1.001);
    longest = std::max(longest, k - 1 - begin);
    begin = k - 1;
    way = StraightWay(at(k - 1), at(k), kTolerance);
  }
  EXPECT_GT(longest, 10);
}

TEST(StraightWay, OfAPointGoesNowhere) {
  StraightWay way({1, 1}, {1, 1}, kTolerance);
  EXPECT_FALSE(way.go_on_to({2, 1}));
}

}  // namespace
}  // namespace spoctree
