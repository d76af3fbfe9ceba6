#include "client/lines/view.hpp"

#include <gtest/gtest.h>

#include "client/lines/outline.hpp"
#include "tests/support/random.hpp"

namespace spoctree {
namespace {

TEST(ProjectedLine, ConvertsParametersBothWays) {
  const Camera camera = Camera::perspective({0, -3, 0.5}, {0.1, 0, 0});
  const Crease crease{{-0.4, -0.9, 0.2}, {0.7, 0.8, -0.3}};
  const ProjectedLine projected = project(crease.a, crease.b, camera);
  for (const double t : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    const Vec2 in_space = camera.project(crease.a + t * (crease.b - crease.a));
    const double s = projected.to_picture(t);
    EXPECT_LT(glm::distance(in_space, projected.a + s * (projected.b - projected.a)), 1e-14);
    EXPECT_NEAR(projected.to_space(s), t, 1e-14);
  }
}

TEST(ProjectedLine, EndsInFrontOfTheViewer) {
  const Camera camera = Camera::perspective({0, 0, 0}, {0, 1, 0});
  const Crease crease{{0.1, -1, 0}, {0.1, 1, 0}};
  const ProjectedLine projected = project(crease.a, crease.b, camera);
  EXPECT_NEAR(projected.range.begin, 0.5 * (1 + camera.least_depth()), 1e-12);
  EXPECT_EQ(projected.range.end, 1);
  EXPECT_NEAR(projected.b.x, 0.1, 1e-15);
  const ProjectedLine behind = project(Vec3{0.1, -1, 0}, Vec3{0.1, -0.1, 0}, camera);
  EXPECT_LE(behind.range.end, behind.range.begin);
}

TEST(ExtentOfBox, IsThatOfItsCorners) {
  Random random(5);
  for (int round = 0; round < 100; ++round) {
    const Vec3 direction{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const Camera camera =
        round % 2 == 0 ? Camera(direction) : Camera::perspective(3.0 * direction, {0, 0, 0});
    const Vec3 lower{random.between(-1, 0), random.between(-1, 0), random.between(-1, 0)};
    const auto extent = extent_of_box({lower, lower + 0.3}, camera);
    if (!extent) continue;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vec2 at = camera.project(lower + 0.3 * Vec3{corner & 1, corner >> 1 & 1, corner >> 2});
      EXPECT_GE(at.x, extent->lower.x - 1e-14);
      EXPECT_GE(at.y, extent->lower.y - 1e-14);
      EXPECT_LE(at.x, extent->upper.x + 1e-14);
      EXPECT_LE(at.y, extent->upper.y + 1e-14);
    }
  }
}

TEST(ProjectedPiece, IsCutWhereTheViewersBackBegins) {
  // The eye is in the middle of a bar along y: what is in front of it fills the picture.
  const Camera camera = Camera::perspective({0, 0, 0}, {0, 1, 0});
  std::vector<Vec3> bar;
  for (unsigned corner = 0; corner < 8; ++corner) {
    bar.push_back({corner & 1 ? 0.1 : -0.1, corner & 2 ? 1 : -1, corner & 4 ? 0.1 : -0.1});
  }
  std::vector<Vec2> points;
  project(bar, camera, points);
  std::vector<Vec2> outline;
  find_outline(points, outline);
  ASSERT_EQ(outline.size(), 4u);
  EXPECT_NEAR(outline[0].x, -0.1 / camera.least_depth(), 1e-3);
  for (Vec3& corner : bar) corner.y -= 2;
  project(bar, camera, points);
  EXPECT_TRUE(points.empty());
}

}  // namespace
}  // namespace spoctree
