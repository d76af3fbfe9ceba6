// The exact method against scenes whose answer is known by reasoning.
#include "tests/support/seen_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "tests/unit/judge/judge_scenes.hpp"

namespace spoctree {
namespace {

/// The part of an edge that is seen, 0 to 1; -1 if there is no such edge.
double share_seen(const std::vector<SeenEdge>& edges, Vec3 a, Vec3 b) {
  for (const SeenEdge& edge : edges) {
    if ((edge.a != a || edge.b != b) && (edge.a != b || edge.b != a)) continue;
    double share = 0;
    for (const auto& [from, to] : edge.visible) share += to - from;
    return share;
  }
  return -1;
}

std::size_t count_seen(const std::vector<SeenEdge>& edges) {
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [](const auto& edge) {
    return edge.hidden.empty() && edge.visible.size() == 1;
  }));
}
std::size_t count_hidden(const std::vector<SeenEdge>& edges) {
  return static_cast<std::size_t>(std::count_if(
      edges.begin(), edges.end(), [](const auto& edge) { return edge.visible.empty(); }));
}

TEST(SeenEdges, ThreeEdgesOfACubeAreHiddenWhereNoneIsSeenAsAPoint) {
  const PlainMesh cube = box({0, 0, 0}, {1, 1, 1});
  const auto edges = seen_edges(cube, JudgeView::parallel({0.3, -0.5, 0.4}));
  ASSERT_EQ(edges.size(), 12u);
  EXPECT_EQ(count_seen(edges), 9u);
  EXPECT_EQ(count_hidden(edges), 3u);
  for (const Vec3 next : {Vec3{1, 1, 0}, Vec3{0, 0, 0}, Vec3{0, 1, 1}}) {
    EXPECT_EQ(share_seen(edges, {0, 1, 0}, next), 0);
  }
}

TEST(SeenEdges, APerspectiveSeesAsManyFacesAsLieTowardsTheEye) {
  const PlainMesh cube = box({0, 0, 0}, {1, 1, 1});
  const Vec3 middle{0.5, 0.5, 0.5};
  const auto three = seen_edges(cube, JudgeView::perspective({4, -3, 2}, middle));
  EXPECT_EQ(count_seen(three), 9u);
  EXPECT_EQ(count_hidden(three), 3u);
  // Over the front face only, though the direction of sight is not square on.
  const auto one = seen_edges(cube, JudgeView::perspective({0.9, -3, 0.2}, middle));
  EXPECT_EQ(count_seen(one), 4u);
  EXPECT_EQ(count_hidden(one), 8u);
}

TEST(SeenEdges, InTheFrontViewOfACubeBackEdgesAreSeenOnlyBesideTheFrontOnes) {
  const auto edges = seen_edges(box({0, 0, 0}, {1, 1, 1}), JudgeView::parallel({0, -1, 0}));
  EXPECT_EQ(edges.size(), 8u);  // four are points
  EXPECT_EQ(share_seen(edges, {0, 0, 0}, {1, 0, 0}), 1);
  // On its outer side nothing is in front of it: the comparison counts both as one.
  EXPECT_EQ(share_seen(edges, {0, 1, 0}, {1, 1, 0}), 1);
}

TEST(SeenEdges, ABarHidesTheMiddleOfWhatIsBehindIt) {
  const PlainMesh scene = together(box({0, 0, 0}, {3, 1, 3}), box({1, -2, -1}, {2, -1, 4}));
  const auto edges = seen_edges(scene, JudgeView::parallel({0, -1, 0}));
  for (const SeenEdge& edge : edges) {
    if (edge.a != Vec3(0, 0, 3) || edge.b != Vec3(3, 0, 3)) continue;
    ASSERT_EQ(edge.visible.size(), 2u);
    EXPECT_NEAR(edge.visible[0].second, 1.0 / 3, 1e-15);
    EXPECT_NEAR(edge.visible[1].first, 2.0 / 3, 1e-15);
    ASSERT_EQ(edge.hidden.size(), 1u);
  }
  EXPECT_NEAR(share_seen(edges, {0, 0, 3}, {3, 0, 3}), 2.0 / 3, 1e-15);
  EXPECT_EQ(share_seen(edges, {1, -2, -1}, {1, -2, 4}), 1);
}

TEST(SeenEdges, AConcaveEdgeIsSeenFromItsOpenSideOnly) {
  const PlainMesh corner = prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0, 1);
  const auto open = seen_edges(corner, JudgeView::parallel({1, 1, 1}));
  EXPECT_EQ(open.size(), 18u);
  EXPECT_EQ(share_seen(open, {1, 1, 0}, {1, 1, 1}), 1);
  EXPECT_EQ(count_hidden(open), 3u);
  EXPECT_EQ(count_seen(open), 15u);
  const auto shut = seen_edges(corner, JudgeView::parallel({-1, -1, 0.5}));
  EXPECT_EQ(share_seen(shut, {1, 1, 0}, {1, 1, 1}), 0);
}

TEST(SeenEdges, SeamsOfAFlatFaceAreNoEdgesAndHideWhatIsExactlyUnderThem) {
  // A plate of cells; behind it a box with an edge exactly under a seam.
  PlainMesh plate = cells(4, [](int, int y, int) { return y == 0; });
  const PlainMesh scene = together(plate, box({2, 2, 1.5}, {3.5, 3, 2.5}));
  const auto edges = seen_edges(scene, JudgeView::parallel({0, -1, 0}));
  EXPECT_EQ(share_seen(edges, {2, 2, 1.5}, {2, 2, 2.5}), 0);
  EXPECT_EQ(share_seen(edges, {2, 0, 1}, {2, 0, 2}), -1);
  EXPECT_EQ(share_seen(edges, {0, 0, 1}, {0, 0, 2}), 1);
}

TEST(SeenEdges, WhatIsExactlyUnderARidgeIsHiddenOnBothSides) {
  // A roof whose ridge, along z at x = 1, faces the viewer at -y.
  const PlainMesh roof = prism({{0, 1}, {1, 0}, {2, 1}}, 0, 4);
  const PlainMesh scene = together(roof, box({1, 2, 1}, {1.5, 3, 2}));
  const auto edges = seen_edges(scene, JudgeView::parallel({0, -1, 0}));
  EXPECT_EQ(share_seen(edges, {1, 0, 0}, {1, 0, 4}), 1);
  EXPECT_EQ(share_seen(edges, {1, 2, 1}, {1, 2, 2}), 0);
}

TEST(SeenEdges, OfARoomTheEyeSeesTheWallsAheadAndNothingOutside) {
  const PlainMesh room = together(box({-1, -1, -1}, {5, 5, 5}), turned(box({0, 0, 0}, {4, 4, 4})));
  const auto view = JudgeView::perspective({2, 2, 2}, {2, 4, 2}, {0, 0, 1}, 80);
  const auto edges = seen_edges(room, view);
  EXPECT_EQ(share_seen(edges, {0, 4, 0}, {4, 4, 0}), 1);
  EXPECT_EQ(share_seen(edges, {-1, 5, -1}, {5, 5, -1}), 0);
  // As far as the window reaches: 2 / tan 80 degrees in front of the eye.
  EXPECT_NEAR(share_seen(edges, {0, 0, 0}, {0, 4, 0}), (2 - 2 / 5.671281819617709) / 4, 1e-9);
  EXPECT_EQ(share_seen(edges, {0, 0, 0}, {4, 0, 0}), -1);  // behind
}

TEST(SeenEdges, AFaceOnlyAlmostFlatHasADoubtfulEdge) {
  // A square folded along a diagonal by less and by more than what counts.
  for (const double bend : {1e-13, 1e-10, 1e-7}) {
    PlainMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, bend}, {0, 1, 0}, {0.5, 0.5, -1}};
    mesh.faces = {{0, 1, 3}, {1, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
    const auto edges = seen_edges(mesh, JudgeView::parallel({0.1, 0.2, 1}));
    const double share = share_seen(edges, {1, 0, 0}, {0, 1, 0});
    EXPECT_EQ(share, bend < 1e-12 ? -1 : 1) << bend;
    const auto doubtful = std::count_if(edges.begin(), edges.end(),
                                        [](const auto& edge) { return edge.is_doubtful; });
    EXPECT_EQ(doubtful, bend == 1e-10 ? 1 : 0) << bend;
  }
}

}  // namespace
}  // namespace spoctree
