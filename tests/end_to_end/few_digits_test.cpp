// A mesh written with few digits, from the file to the drawing: the faces it had, and why.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/end_to_end/programs.hpp"

namespace spoctree::test {
namespace {

// A box of 120 by 80 by 30, turned, each face four triangles around its middle.
std::string turned_box(const char* format) {
  const double a = 0.5;
  const double b = 0.7;
  std::array<std::array<double, 3>, 14> points{};
  for (unsigned i = 0; i < 8; ++i) {
    const double x = 120.0 * (i & 1);
    const double y = 80.0 * ((i >> 1) & 1);
    const double z = 30.0 * (i >> 2);
    const double u = std::cos(a) * x - std::sin(a) * y;
    const double v = std::sin(a) * x + std::cos(a) * y;
    points[i] = {u, std::cos(b) * v - std::sin(b) * z, std::sin(b) * v + std::cos(b) * z};
  }
  const unsigned faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
  std::string triangles;
  for (unsigned f = 0; f < 6; ++f) {
    for (unsigned i = 0; i < 4; ++i) {
      for (unsigned axis = 0; axis < 3; ++axis)
        points[8 + f][axis] += points[faces[f][i]][axis] / 4;
      triangles += "f " + std::to_string(faces[f][i] + 1) + " " +
                   std::to_string(faces[f][(i + 1) % 4] + 1) + " " + std::to_string(f + 9) + "\n";
    }
  }
  std::string text;
  for (const auto& point : points) {
    text += "v";
    for (const double x : point) {
      std::array<char, 64> number;
      std::snprintf(number.data(), number.size(), format, x);
      text += " " + std::string(number.data());
    }
    text += "\n";
  }
  return text + triangles;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

class FewDigits : public testing::Test {
 protected:
  std::string mesh(const char* format) const {
    write_file(folder_.file("box.obj"), turned_box(format));
    return folder_.file("box.obj");
  }
  std::string summary(const char* format, const Arguments& more = {}) const {
    Arguments arguments = {"build", mesh(format), "-o", spo_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_server(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  }
  std::size_t lines() const {
    const Outcome drawing = run_client(
        {"draw", spo_, "-o", "-", "--format", "json", "--from", "1,-2,0.7", "--crease-angle", "0"});
    EXPECT_EQ(drawing.code, 0) << drawing.err;
    return count(drawing.out, "\"kind\"");
  }

  TemporaryFolder folder_;
  const std::string spo_ = folder_.file("box.spo");
};

TEST_F(FewDigits, ABoxIsDrawnAsOne) {
  for (const char* format : {"%.4g", "%.5g", "%.6g", "%.9g", "%.17g"}) {
    EXPECT_NE(summary(format).find("24 faces, 6 planes"), std::string::npos) << format;
    EXPECT_EQ(lines(), 9u) << format;
  }
}

TEST_F(FewDigits, WhatCountsAsFlatIsSaidWithTheReason) {
  EXPECT_NE(summary("%.5g").find("the file has 5 significant digits, coordinates may be rounded to "),
            std::string::npos);
  EXPECT_NE(run_server({"info", spo_}).out.find("rounding=0.01"), std::string::npos);
  EXPECT_NE(run_server({"info", folder_.file("box.obj")}).out.find("5 significant digits"),
            std::string::npos);
  EXPECT_NE(summary("%.17g").find("(1e-06 of the diagonal)"), std::string::npos);
}

TEST_F(FewDigits, AGivenToleranceOverridesWhatTheFileSays) {
  const std::string text = summary("%.4g", {"--flat-tolerance", "1e-6"});
  EXPECT_EQ(text.find("6 planes"), std::string::npos);
  EXPECT_NE(text.find("1e-06 of the diagonal, as given"), std::string::npos) << text;
  EXPECT_EQ(run_server({"info", spo_}).out.find("rounding="), std::string::npos);
  EXPECT_GT(lines(), 9u);
}

}  // namespace
}  // namespace spoctree::test
