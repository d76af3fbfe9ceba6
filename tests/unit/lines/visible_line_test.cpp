#include "client/lines/visible_line.hpp"

#include <gtest/gtest.h>

namespace spoctree {
namespace {

LineStretch stretch(double end, int level) {
  return {end,
          {NodeKind::Convex, static_cast<std::uint8_t>(level), false},
          {PlaneRef::of_table(1), PlaneRef::of_table(2)}};
}

/// From x = 0 to x = 10: level 3 as far as 2, level 4 as far as 7, level 5 as far as 10.
VisibleLine three_stretches() {
  VisibleLine line;
  line.b = {10, 0, 0};
  const LineStretch stretches[] = {stretch(0.2, 3), stretch(0.7, 4), stretch(1, 5)};
  set_stretches(line, stretches);
  return line;
}

TEST(VisibleLine, IsOfItsLongestStretch) { EXPECT_EQ(three_stretches().source.level, 4); }

TEST(VisibleLine, HasEqualNeighboursAsOneStretch) {
  VisibleLine line;
  const LineStretch stretches[] = {stretch(0.2, 3), stretch(0.5, 3), stretch(1, 4)};
  set_stretches(line, stretches);
  ASSERT_EQ(line.stretches.size(), 2u);
  EXPECT_EQ(line.stretches[0].end, 0.5);
  const LineStretch alike[] = {stretch(0.2, 3), stretch(1, 3)};
  set_stretches(line, alike);
  EXPECT_TRUE(line.stretches.empty());
  EXPECT_EQ(line.source.level, 3);
  ASSERT_EQ(stretches_of(line).size(), 1u);
  EXPECT_EQ(stretches_of(line)[0].end, 1);
}

TEST(VisibleLine, TakesPlanesInEitherOrderForTheSame) {
  LineStretch one = stretch(0.5, 3);
  LineStretch other = stretch(1, 3);
  std::swap(other.planes[0], other.planes[1]);
  EXPECT_TRUE(one.goes_on_in(other));
  other.planes[0] = PlaneRef::of_table(3);
  EXPECT_FALSE(one.goes_on_in(other));
}

TEST(VisibleLine, KeepsItsStretchesWhereItIsCut) {
  const VisibleLine part = cut(three_stretches(), 0.1, 0.6);
  EXPECT_EQ(part.a.x, 1);
  EXPECT_EQ(part.b.x, 6);
  ASSERT_EQ(part.stretches.size(), 2u);
  EXPECT_NEAR(part.stretches[0].end, 0.2, 1e-15);
  EXPECT_EQ(part.stretches[0].source.level, 3);
  EXPECT_EQ(part.stretches[1].end, 1);
  EXPECT_EQ(part.stretches[1].source.level, 4);
  const VisibleLine middle = cut(three_stretches(), 0.2, 0.7);
  EXPECT_TRUE(middle.stretches.empty());
  EXPECT_EQ(middle.source.level, 4);
}

TEST(VisibleLine, TurnsWithItsStretches) {
  const VisibleLine back = reversed(three_stretches());
  EXPECT_EQ(back.a.x, 10);
  EXPECT_EQ(back.b.x, 0);
  ASSERT_EQ(back.stretches.size(), 3u);
  EXPECT_NEAR(back.stretches[0].end, 0.3, 1e-15);
  EXPECT_EQ(back.stretches[0].source.level, 5);
  EXPECT_NEAR(back.stretches[1].end, 0.8, 1e-15);
  EXPECT_EQ(back.stretches[2].end, 1);
  EXPECT_EQ(back.stretches[2].source.level, 3);
}

}  // namespace
}  // namespace spoctree
