// What a caller hears of long work on a level, and how it ends that.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <vector>

#include "client/lines/visible_lines.hpp"
#include "client/rebuild/surface_rebuilder.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

/// A ball of cubes, large enough for inner loops to tell something.
Octree large_tree() {
  return tree_of({6, [](int x, int y, int z) {
                    const Vec3 from_middle{x - 31.5, y - 31.5, z - 31.5};
                    return glm::dot(from_middle, from_middle) < 30 * 30;
                  }});
}

constexpr double kRebuilding = 0.4;
constexpr double kPreparing = 0.4;
constexpr double kDrawing = 0.2;

VisibleLines draw(
    const Octree& tree, const ProgressReport& report,
    const std::function<void()>& after_step = [] {}) {
  ProgressMeter meter(report);
  const ProgressShare all(meter);
  const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
  const Surface surface = SurfaceRebuilder().rebuild(tree, last, all.part(kRebuilding));
  after_step();
  const LineScene scene(tree, surface, last, all.part(kPreparing));
  after_step();
  LineOptions options;
  options.with_hidden_lines = true;
  options.progress = all.part(kDrawing);
  return visible_lines(scene, Camera(), options);
}

TEST(ProgressOfADrawing, NeverGoesBackAndTellsOfAllSteps) {
  std::vector<double> told;
  std::vector<std::size_t> told_by_then;
  draw(
      large_tree(), [&](double fraction) { told.push_back(fraction); },
      [&] { told_by_then.push_back(told.size()); });
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  ASSERT_EQ(told_by_then.size(), 2u);
  EXPECT_GE(told_by_then[0], 5u);
  EXPECT_GE(told_by_then[1], told_by_then[0] + 5);
  EXPECT_GE(told.size(), told_by_then[1] + 5);
  EXPECT_GT(told.back(), 0.8);
  EXPECT_LE(told.back(), 1);
}

TEST(ProgressOfADrawing, ChangesNothing) {
  const Octree tree = large_tree();
  const VisibleLines quiet = draw(tree, {});
  const VisibleLines told = draw(tree, [](double) {});
  ASSERT_EQ(quiet.size(), told.size());
  for (std::size_t k = 0; k < quiet.size(); ++k) {
    EXPECT_EQ(quiet[k].a, told[k].a);
    EXPECT_EQ(quiet[k].b, told[k].b);
  }
}

TEST(ProgressOfADrawing, EndsTheWorkWhereverItsReportThrows) {
  const Octree tree = large_tree();
  std::vector<double> told;
  draw(tree, [&](double fraction) { told.push_back(fraction); });
  for (std::size_t k = 0; k < told.size(); k += 1 + told.size() / 30) {
    // Threads are in each other's way: not always the same fractions are told.
    const double until = 0.9 * told[k];
    const ProgressReport report = [&](double fraction) {
      if (fraction >= until) throw std::runtime_error("cancelled");
    };
    EXPECT_THROW(draw(tree, report), std::runtime_error) << until;
  }
}

}  // namespace
}  // namespace spoctree
