// The boxes over points against asking every point.
#include "server/build/reach_boxes.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/random.hpp"

namespace spoctree {
namespace {

Vec3 random_vector(Random& random) {
  return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

TEST(ReachBoxes, FindWhatAskingEveryPointFinds) {
  std::size_t yes = 0;
  std::size_t no = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    ReachBoxes boxes;
    boxes.add(Vec3(100), 0);  // forgotten by `clear`
    boxes.clear();
    struct Point {
      Vec3 position;
      double error;
    };
    std::vector<Point> points;
    const std::uint32_t count = 1 + random.below(300);
    for (std::uint32_t i = 0; i < count; ++i) {
      // Many of them in one plane: z = 1/4.
      Vec3 position = random_vector(random);
      if (random.chance(0.7)) position.z = 0.25;
      points.push_back({position, random.chance(0.5) ? 0.0 : 1e-3});
      boxes.add(position, points.back().error);
    }
    boxes.prepare();
    for (int i = 0; i < 50; ++i) {
      const Vec3 normal = i == 0 ? Vec3(0, 0, 1) : glm::normalize(random_vector(random));
      const double offset = i == 0 ? 0.25 : random.between(-1.2, 1.2);
      for (const double doubt : {0x1p-46, 1e-4}) {
        bool expected = false;
        for (const Point& point : points) {
          expected |= glm::dot(normal, point.position) - offset > doubt + 2 * point.error;
        }
        ASSERT_EQ(boxes.any_beyond(normal, offset, doubt), expected);
        (expected ? yes : no) += 1;
      }
    }
  }
  EXPECT_GT(yes, 100u);
  EXPECT_GT(no, 100u);
}

TEST(ReachBoxes, HaveNothingBeyondAnyPlaneWhenEmpty) {
  ReachBoxes boxes;
  boxes.prepare();
  EXPECT_FALSE(boxes.any_beyond(Vec3(0, 0, 1), -10, 0x1p-46));
}

}  // namespace
}  // namespace spoctree
