#include "client/draw/pen.hpp"

#include <gtest/gtest.h>

#include "client/draw/fixed_number.hpp"

namespace spoctree {
namespace {

// The colours of image 1 of the paper; VERTEX nodes are ours.
TEST(Pen, InksAreThoseOfThePaper) {
  const auto ink = [](NodeKind kind, bool is_inherited) {
    return ink_of_kind({kind, 3, is_inherited});
  };
  EXPECT_EQ(ink(NodeKind::Grey, false), Ink::Grey);
  EXPECT_EQ(ink(NodeKind::Grey, true), Ink::Grey);
  EXPECT_EQ(ink(NodeKind::Convex, false), Ink::Green);
  EXPECT_EQ(ink(NodeKind::Concave, false), Ink::Blue);
  EXPECT_EQ(ink(NodeKind::Concave, true), Ink::Yellow);
  EXPECT_EQ(ink(NodeKind::Convex, true), Ink::Red);
  EXPECT_EQ(ink(NodeKind::Vertex, false), Ink::Purple);
  EXPECT_EQ(ink(NodeKind::Vertex, true), Ink::Purple);
}

TEST(Pen, DrawsHiddenLinesFirstAndFinalLinesLast) {
  Pen hidden_silhouette;
  hidden_silhouette.hidden = true;
  hidden_silhouette.use = PenUse::Silhouette;
  Pen step;
  step.is_step = true;
  Pen silhouette;
  silhouette.use = PenUse::Silhouette;
  EXPECT_LT(hidden_silhouette, step);
  EXPECT_LT(step, Pen{});
  EXPECT_LT(Pen{}, silhouette);
}

TEST(Pen, NamesSayAllThatApplies) {
  Pen pen;
  pen.use = PenUse::Silhouette;
  pen.is_step = pen.hidden = true;
  pen.ink = Ink::Blue;
  EXPECT_EQ(name_of(pen, ' '), "silhouette step hidden blue");
  EXPECT_EQ(name_of(Pen{}, '_'), "crease");
  EXPECT_EQ(to_hex({255, 0, 16}), "#ff0010");
}

TEST(FixedNumber, IsShort) {
  for (const auto& [value, text] :
       std::initializer_list<std::pair<double, const char*>>{{0, "0"},
                                                             {-0.001, "0"},
                                                             {0.5, ".5"},
                                                             {-0.05, "-.05"},
                                                             {12.3, "12.3"},
                                                             {100, "100"},
                                                             {-7.125, "-7.13"},
                                                             {99.999, "100"}}) {
    EXPECT_EQ(to_decimal(value, 2), text);
  }
  EXPECT_EQ(to_decimal(1200, 0), "1200");
}

}  // namespace
}  // namespace spoctree
