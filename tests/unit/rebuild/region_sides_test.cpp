#include "client/rebuild/region_sides.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "tests/support/random.hpp"

namespace spoctree {
namespace {

const PlaneFrame kFrame({{0, 0, 1}, 0}, false);

/// Checks that all edges are in one of the two lists, the one reversed, and arrive as often as they
/// leave in each.
void expect_cycles(std::span<const CountedEdge> edges, const std::vector<PlaneEdge>& front,
                   const std::vector<PlaneEdge>& back, std::size_t vertex_count) {
  std::size_t uses = 0;
  for (const CountedEdge& edge : edges) uses += static_cast<std::size_t>(edge.count);
  EXPECT_EQ(front.size() + back.size(), uses);
  for (const auto* list : {&front, &back}) {
    std::vector<int> leaving(vertex_count);
    for (const PlaneEdge& edge : *list) {
      ++leaving[edge.from];
      --leaving[edge.to];
    }
    EXPECT_EQ(leaving, std::vector<int>(vertex_count));
  }
}

TEST(SeparateSides, TellsAFaceSeenFromBehindByItsTurn) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {-1, 0, 0}};
  const std::vector<CountedEdge> edges{{{0, 1}, 1}, {{1, 2}, 1}, {{2, 0}, 1},
                                       {{0, 3}, 1}, {{3, 4}, 1}, {{4, 0}, 1}};
  std::vector<PlaneEdge> front;
  std::vector<PlaneEdge> back;
  separate_sides(edges, kFrame, points, front, back);
  expect_cycles(edges, front, back, points.size());
  EXPECT_EQ(front.size(), 3u);
  EXPECT_EQ(back.size(), 3u);
}

TEST(SeparateSides, GivesCyclesWhereEdgesCross) {
  // Closed ways over random points of a small grid: they cross, overlap and turn back.
  std::vector<PlaneEdge> front;
  std::vector<PlaneEdge> back;
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    Random random(seed);
    const std::uint32_t count = 4 + random.below(6);
    std::vector<Vec3> points;
    for (std::uint32_t i = 0; i < count; ++i) {
      points.emplace_back(random.below(5), random.below(5), 0);
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> counts;
    for (std::uint32_t way = 0; way < 3; ++way) {
      const std::uint32_t first = random.below(count);
      std::uint32_t at = first;
      for (std::uint32_t step = 0; step < 8; ++step) {
        const std::uint32_t to = step == 7 ? first : random.below(count);
        if (at < to) ++counts[{at, to}];
        if (at > to) --counts[{to, at}];
        at = to;
      }
    }
    std::vector<CountedEdge> edges;
    for (const auto& [ends, times] : counts) {
      const auto [a, b] = ends;
      if (times > 0) edges.push_back({{a, b}, times});
      if (times < 0) edges.push_back({{b, a}, -times});
    }
    if (edges.empty()) continue;
    separate_sides(edges, kFrame, points, front, back);
    expect_cycles(edges, front, back, points.size());
    if (HasFailure()) FAIL() << "seed " << seed;
  }
}

}  // namespace
}  // namespace spoctree
