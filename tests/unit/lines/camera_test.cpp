#include "client/lines/camera.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "common/base/errors.hpp"

namespace spoctree {
namespace {

TEST(Camera, HasExactAxesInViewsAlongAnAxis) {
  const Camera front(Vec3{0, -3, 0});
  EXPECT_EQ(front.right(), Vec3(1, 0, 0));
  EXPECT_EQ(front.up(), Vec3(0, 0, 1));
  EXPECT_EQ(front.toward_viewer(), Vec3(0, -1, 0));
  const Camera left(Vec3{-1, 0, 0});
  EXPECT_EQ(left.right(), Vec3(0, -1, 0));
  EXPECT_EQ(left.up(), Vec3(0, 0, 1));
}

TEST(Camera, TakesYAsUpInViewsAlongZ) {
  const Camera top(Vec3{0, 0, 2});
  EXPECT_EQ(top.up(), Vec3(0, 1, 0));
  EXPECT_EQ(top.right(), Vec3(1, 0, 0));
  const Camera bottom(Vec3{0, 0, -1e-300});
  EXPECT_EQ(bottom.up(), Vec3(0, 1, 0));
  EXPECT_EQ(bottom.right(), Vec3(-1, 0, 0));
}

TEST(Camera, IsRightHandedAndOfUnitLengthFromAnywhere) {
  for (const Vec3 direction : {Vec3{0.55, -0.71, 0.44}, Vec3{1e200, 1e200, -1e200},
                               Vec3{1e-200, 3e-200, 0}, Vec3{-1, 1e-9, 5}}) {
    const Camera camera(direction);
    EXPECT_NEAR(glm::length(camera.right()), 1, 1e-15);
    EXPECT_NEAR(glm::length(camera.up()), 1, 1e-15);
    EXPECT_LT(glm::distance(glm::cross(camera.right(), camera.up()), camera.toward_viewer()),
              1e-15);
    EXPECT_GE(camera.up().z, 0);
    EXPECT_EQ(camera.right().z, 0);
  }
}

TEST(Camera, RejectsDirectionsThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Vec3 direction : {Vec3{0, 0, 0}, Vec3{nan, 1, 1}, Vec3{1, nan, 0}, Vec3{0, 0, nan},
                               Vec3{infinity, 0, 0}, Vec3{1, 1, -infinity}}) {
    EXPECT_THROW(Camera{direction}, UsageError);
  }
}

TEST(Camera, KnowsWhichPlanesFaceIt) {
  const Camera camera(Vec3{0, -1, 0});
  EXPECT_EQ(camera.facing({{0, -1, 0}, 0.5}), 1);
  EXPECT_EQ(camera.facing({{0, 1, 0}, 0.5}), -1);
  EXPECT_EQ(camera.facing({{1, 0, 0}, 0.5}), 0);
}

}  // namespace
}  // namespace spoctree
