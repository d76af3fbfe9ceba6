#include "client/rebuild/loop_tracer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace spoctree {
namespace {

const PlaneFrame kFrame({{0, 0, 1}, 0}, false);

TEST(LoopTracer, KeepsTheBladesOfAFanApart) {
  // So many that going through all of them at every turn would not end in a test.
  constexpr std::uint32_t kBlades = 100000;
  std::vector<Vec3> points{{0, 0, 0}};
  std::vector<PlaneEdge> edges;
  for (std::uint32_t i = 0; i < kBlades; ++i) {
    for (const double side : {0.25, 0.75}) {
      const double angle = 2 * M_PI * (i + side) / kBlades;
      points.push_back({std::cos(angle), std::sin(angle), 0});
    }
    edges.insert(edges.end(), {{0, 2 * i + 1}, {2 * i + 1, 2 * i + 2}, {2 * i + 2, 0}});
  }
  LoopTracer tracer;
  TracedLoops result;
  tracer.trace(edges, kFrame, points, result);
  EXPECT_TRUE(result.branches);
  ASSERT_EQ(result.loops.size(), kBlades);
  for (const TracedLoops::Loop& loop : result.loops) {
    ASSERT_EQ(loop.count, 3u);
    ASSERT_GT(loop.area, 0);
  }
}

TEST(LoopTracer, TakesAnEdgeThatIsThereManyTimesAsOften) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<PlaneEdge> edges;
  for (int i = 0; i < 10000; ++i) edges.insert(edges.end(), {{0, 1}, {1, 2}, {2, 0}});
  LoopTracer tracer;
  TracedLoops result;
  tracer.trace(edges, kFrame, points, result);
  ASSERT_EQ(result.loops.size(), 10000u);
  for (const TracedLoops::Loop& loop : result.loops) {
    const auto vertices = result.vertices_of(loop);
    EXPECT_EQ(std::set<std::uint32_t>(vertices.begin(), vertices.end()).size(), 3u);
  }
}

TEST(LoopTracer, RefusesWhatIsNoCycle) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  LoopTracer tracer;
  TracedLoops result;
  std::vector<PlaneEdge> dead_end{{0, 1}, {1, 2}};
  EXPECT_THROW(tracer.trace(dead_end, kFrame, points, result), std::logic_error);
  std::vector<PlaneEdge> more_arrive{{0, 1}, {1, 2}, {2, 0}, {3, 1}};
  EXPECT_THROW(tracer.trace(more_arrive, kFrame, points, result), std::logic_error);
}

}  // namespace
}  // namespace spoctree
