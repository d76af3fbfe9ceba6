#include "client/rebuild/region_sides.hpp"

#include <gtest/gtest.h>

#include <array>

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
  // All closed ways of five steps over the corners of a pentagon, and twice some, crossing or not.
  std::vector<Vec3> points;
  for (const auto& [x, y] : {std::array{0, 3}, {-3, 1}, {-2, -2}, {2, -2}, {3, 1}}) {
    points.push_back({x, y, 0});
  }
  std::vector<PlaneEdge> front;
  std::vector<PlaneEdge> back;
  for (unsigned code = 0; code < 3125 * 25; ++code) {
    int counts[5][5] = {};
    unsigned rest = code;
    const unsigned first = rest % 5;
    unsigned at = first;
    for (int step = 0; step < 7; ++step, rest /= 5) {
      const unsigned to = step == 6 ? first : rest % 5;
      if (at == to) continue;
      ++counts[at][to];
      --counts[to][at];
      at = to;
    }
    std::vector<CountedEdge> edges;
    for (std::uint32_t i = 0; i < 5; ++i) {
      for (std::uint32_t j = 0; j < 5; ++j) {
        if (counts[i][j] > 0) edges.push_back({{i, j}, counts[i][j]});
      }
    }
    if (edges.empty()) continue;
    separate_sides(edges, kFrame, points, front, back);
    expect_cycles(edges, front, back, points.size());
    if (HasFailure()) FAIL() << "code " << code;
  }
}

}  // namespace
}  // namespace spoctree
