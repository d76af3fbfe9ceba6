// Drawings that are right, by reasoning, and drawings spoiled in every way that the judge is to
// find.
#include "tests/support/drawing_judge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/judge/judge_scenes.hpp"

namespace spoctree {
namespace {

/// The lines of a box's face towards -y.
std::vector<DrawnLine> front(Vec3 lower, Vec3 upper) {
  const double y = lower.y;
  const Vec3 corners[] = {
      {lower.x, y, lower.z}, {upper.x, y, lower.z}, {upper.x, y, upper.z}, {lower.x, y, upper.z}};
  std::vector<DrawnLine> result;
  for (int k = 0; k < 4; ++k) result.push_back({corners[k], corners[(k + 1) % 4], false});
  return result;
}

std::vector<DrawnLine> together(std::vector<DrawnLine> one, const std::vector<DrawnLine>& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

void expect_clean(const DrawingJudgement& found, double seen, std::size_t lines) {
  EXPECT_TRUE(found.is_good());
  for (const std::string& fault : found.faults) ADD_FAILURE() << fault;
  EXPECT_NEAR(found.seen, seen, 1e-9);
  EXPECT_EQ(found.seen_runs, lines);
  EXPECT_EQ(found.runs, lines);
  EXPECT_EQ(found.lines, lines);
  EXPECT_EQ(found.pieces_per_run(), 1);
}

TEST(DrawingJudge, TheFrontViewOfACubeIsASquare) {
  const auto found = judge_drawing(box({0, 0, 0}, {1, 1, 1}), JudgeView::parallel({0, -1, 0}),
                                   front({0, 0, 0}, {1, 1, 1}));
  expect_clean(found, 4, 4);
  EXPECT_NEAR(found.behind, 0, 1e-9);
}

TEST(DrawingJudge, APerspectiveFrontViewIsASquareAsLargeAsItIsNear) {
  const auto view = JudgeView::perspective({0.5, -3, 0.5}, {0.5, 0.5, 0.5});
  const auto found = judge_drawing(box({0, 0, 0}, {1, 1, 1}), view, front({0, 0, 0}, {1, 1, 1}));
  expect_clean(found, 4 * 3.5 / 3, 4);
  // Hidden: the back face, smaller, and the four edges to it, along the lines to its corners.
  const double back = 3.5 / 4;
  EXPECT_NEAR(found.behind, 4 * back + 4 * std::sqrt(0.5) * (3.5 / 3 - back), 1e-9);
}

TEST(DrawingJudge, ABracketIsFiveLinesFromTheFront) {
  const PlainMesh bracket =
      prism({{0, 0}, {2, 0}, {2, 3}, {1, 3}, {1, 1}, {0, 1}}, 0, 4, [](Vec3 p) {
        return Vec3{p.z, p.x, p.y};
      });
  const auto right = together(front({0, 0, 0}, {4, 2, 3}), lines({{{0, 0, 1}, {4, 0, 1}}}));
  const JudgeView view = JudgeView::parallel({0, -1, 0});
  // Lines along edges that lie in front of each other are right wherever they are in space, but on
  // some edge: here the side lines are taken from the back, where they are not broken.
  auto drawn = right;
  for (DrawnLine& line : drawn) {
    if (line.a.x == line.b.x) line.a.y = line.b.y = 2;
    if (line.a.z == 3 && line.b.z == 3) line.a.y = line.b.y = 1;
  }
  expect_clean(judge_drawing(bracket, view, drawn), 18, 5);
  // In front of the plate there is no edge in space.
  EXPECT_NEAR(judge_drawing(bracket, view, right).off_in_space, 2 * 2 + 4, 1e-4);
  EXPECT_TRUE(judge_drawing(bracket, view, right).is_good());
}

TEST(DrawingJudge, TheFaceOfAMengerSpongeIsSquaresInASquare) {
  const PlainMesh sponge = cells(9, [](int x, int y, int z) { return is_in_sponge(x, y, z, 2); });
  std::vector<DrawnLine> drawn = front({0, 0, 0}, {9, 9, 9});
  drawn = together(drawn, front({3, 0, 3}, {6, 9, 6}));
  for (int x = 0; x < 3; ++x) {
    for (int z = 0; z < 3; ++z) {
      if (x == 1 && z == 1) continue;
      const Vec3 low(3 * x + 1, 0, 3 * z + 1);
      drawn = together(drawn, front(low, low + Vec3(1, 9, 1)));
    }
  }
  const auto found = judge_drawing(sponge, JudgeView::parallel({0, -1, 0}), drawn);
  expect_clean(found, 36 + 12 + 32, 40);
}

TEST(DrawingJudge, CoplanarFacesOfTwoPartsHaveTheirOwnLines) {
  const PlainMesh parts = together(box({0, 0, 0}, {1, 1, 1}), box({1.5, 0, 0}, {3, 1, 1}));
  const auto drawn = together(front({0, 0, 0}, {1, 1, 1}), front({1.5, 0, 0}, {3, 1, 1}));
  expect_clean(judge_drawing(parts, JudgeView::parallel({0, -1, 0}), drawn), 4 + 5, 8);
}

/// A box before another, both square on; the front one hides the middle.
struct BoxBeforeBox : testing::Test {
  PlainMesh mesh = together(box({0, 0, 0}, {3, 1, 3}), box({1, -2, -1}, {2, -1, 4}));
  JudgeView view = JudgeView::parallel({0, -1, 0});
  std::vector<DrawnLine> right =
      together(front({1, -2, -1}, {2, -1, 4}), lines({{{0, 0, 0}, {0, 0, 3}},
                                                      {{3, 0, 0}, {3, 0, 3}},
                                                      {{0, 0, 0}, {1, 0, 0}},
                                                      {{2, 0, 0}, {3, 0, 0}},
                                                      {{0, 0, 3}, {1, 0, 3}},
                                                      {{2, 0, 3}, {3, 0, 3}}}));
  double diagonal = diagonal_of(mesh);

  DrawingJudgement judge(const std::vector<DrawnLine>& drawn) const {
    return judge_drawing(mesh, view, drawn);
  }
};

TEST_F(BoxBeforeBox, IsRight) {
  expect_clean(judge(right), 22, 10);
  EXPECT_NEAR(judge(right).behind, 2, 1e-9);
}

TEST_F(BoxBeforeBox, ALineLeftOutIsMissed) {
  right.pop_back();
  const auto found = judge(right);
  EXPECT_FALSE(found.is_good());
  EXPECT_NEAR(found.missed, 1, 1e-4);
  EXPECT_EQ(found.faults.size(), 1u);
  EXPECT_EQ(found.not_seen + found.no_edge + found.doubled, 0);
}

TEST_F(BoxBeforeBox, AShortGapIsMissed) {
  right.back().a.x += 1e-4;
  EXPECT_NEAR(judge(right).missed, 1e-4, 2 * 1e-6 * diagonal);
}

TEST_F(BoxBeforeBox, AHiddenLineThatIsDrawnIsFound) {
  right.push_back({{1, 0, 3}, {2, 0, 3}, false});
  const auto found = judge(right);
  EXPECT_FALSE(found.is_good());
  EXPECT_NEAR(found.not_seen, 1, 1e-4);
  EXPECT_EQ(found.missed + found.no_edge + found.doubled, 0);
}

TEST_F(BoxBeforeBox, AHiddenBackEdgeUnderAVisibleOneIsNoFault) {
  // The top line of the front bar, taken from the bar's back.
  for (DrawnLine& line : right) {
    if (line.a.z == 4 && line.b.z == 4) line.a.y = line.b.y = -1;
  }
  expect_clean(judge(right), 22, 10);
}

TEST_F(BoxBeforeBox, ALineDrawnTwiceIsFound) {
  right.push_back({{0.25, 0, 3}, {0.75, 0, 3}, false});
  const auto found = judge(right);
  EXPECT_FALSE(found.is_good());
  EXPECT_NEAR(found.doubled, 0.5, 1e-9);
  EXPECT_EQ(found.missed + found.no_edge + found.not_seen, 0);
  EXPECT_EQ(found.runs, 10u);
}

TEST_F(BoxBeforeBox, ALineOffByTenTimesTheToleranceIsNoEdgeAndMissesOne) {
  const double off = 1e-5 * diagonal;
  right.back().a.z += off;
  right.back().b.z += off;
  const auto found = judge(right);
  EXPECT_NEAR(found.no_edge, 1, 1e-4);
  EXPECT_NEAR(found.missed, 1, 1e-4);
}

TEST_F(BoxBeforeBox, ALineOffInDepthOnlyIsRightInThePicture) {
  right.back().a.y -= 1e-5 * diagonal;
  right.back().b.y -= 1e-5 * diagonal;
  const auto found = judge(right);
  EXPECT_NEAR(found.off_in_space, 1, 1e-4);
  EXPECT_EQ(found.missed, 0);
  EXPECT_TRUE(found.is_good());
}

TEST_F(BoxBeforeBox, ALineOffByATenthOfTheToleranceIsRight) {
  right.back().a.z += 1e-7 * diagonal;
  right.back().b.z += 1e-7 * diagonal;
  EXPECT_TRUE(judge(right).is_good());
}

TEST_F(BoxBeforeBox, ALineAcrossAFaceIsNoEdge) {
  right.push_back({{1, -2, -1}, {2, -2, 4}, false});
  EXPECT_NEAR(judge(right).no_edge, std::sqrt(26.0), 1e-3);
}

TEST_F(BoxBeforeBox, ABrokenLineIsTwoPiecesOfOneRun) {
  const DrawnLine last = right.back();
  const Vec3 middle = last.a + 0.3 * (last.b - last.a);
  right.back().b = middle;
  right.push_back({middle, last.b, false});
  const auto found = judge(right);
  EXPECT_TRUE(found.is_good());
  EXPECT_EQ(found.lines, 11u);
  EXPECT_EQ(found.runs, 10u);
  EXPECT_NEAR(found.pieces_per_run(), 1.1, 1e-12);
}

TEST_F(BoxBeforeBox, DashedLinesAreJudgedByWhatIsHidden) {
  right.push_back({{1, 0, 3}, {2, 0, 3}, true});
  auto found = judge(right);  // that at z = 0 is missing
  EXPECT_NEAR(found.missed_hidden, 1, 1e-4);
  right.push_back({{1, 0, 0}, {2, 0, 0}, true});
  found = judge(right);
  EXPECT_TRUE(found.is_good());
  EXPECT_EQ(found.lines, 10u);
  EXPECT_EQ(found.hidden_lines, 2u);
  // Dashed where it is seen: dashed wrongly, and on a visible line.
  right.push_back({{0, 0, 0}, {0, 0, 3}, true});
  found = judge(right);
  EXPECT_NEAR(found.wrongly_hidden, 3, 1e-9);
  EXPECT_NEAR(found.doubled_hidden, 3, 1e-9);
  EXPECT_FALSE(found.is_good());
}

TEST(DrawingJudge, ASeenEdgeThatIsDashedIsFound) {
  const auto view = JudgeView::perspective({0.5, -3, 0.5}, {0.5, 0.5, 0.5});
  auto drawn = front({0, 0, 0}, {1, 1, 1});
  drawn.back().is_hidden = true;
  const auto found = judge_drawing(box({0, 0, 0}, {1, 1, 1}), view, drawn);
  EXPECT_NEAR(found.missed, 3.5 / 3, 1e-4);
  EXPECT_NEAR(found.wrongly_hidden, 3.5 / 3, 1e-4);
}

}  // namespace
}  // namespace spoctree
