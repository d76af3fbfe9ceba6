// Models turned and written with few digits have the faces that they had before; models that mean
// every digit keep every face; and no corner moves farther than rounding explains.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <string>

#include "common/base/errors.hpp"
#include "server/mesh/read_mesh.hpp"
#include "server/solid/import_solid.hpp"
#include "tools/model/models.hpp"

namespace spoctree {
namespace {

using model::PolygonMesh;

PolygonMesh box(glm::dvec3 size) {
  PolygonMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.points.push_back(size * glm::dvec3(i & 1, (i >> 1) & 1, i >> 2));
  }
  mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
  return mesh;
}

/// Each face as triangles around a point in its middle: no two of them are in one plane when all
/// points have been rounded.
PolygonMesh with_middles(const PolygonMesh& mesh) {
  PolygonMesh fans;
  fans.points = mesh.points;
  for (const model::Loop& face : mesh.faces) {
    glm::dvec3 middle{};
    for (const std::uint32_t corner : face) middle += mesh.points[corner];
    const auto number = static_cast<std::uint32_t>(fans.points.size());
    fans.points.push_back(middle / static_cast<double>(face.size()));
    for (std::size_t i = 0; i < face.size(); ++i) {
      fans.faces.push_back({face[i], face[(i + 1) % face.size()], number});
    }
  }
  return fans;
}

glm::dmat3 random_turn(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto direction = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
  const glm::dvec3 x = glm::normalize(direction());
  const glm::dvec3 y = glm::normalize(glm::cross(direction(), x));
  return {x, y, glm::cross(x, y)};
}

PolygonMesh placed(PolygonMesh mesh, const glm::dmat3& turn, glm::dvec3 shift) {
  for (glm::dvec3& p : mesh.points) p = turn * p + shift;
  return mesh;
}

/// OFF with numbers as printf writes them.
std::string print(const PolygonMesh& mesh, const char* format) {
  std::string text = "OFF\n" + std::to_string(mesh.points.size()) + " " +
                     std::to_string(mesh.faces.size()) + " 0\n";
  for (const glm::dvec3& p : mesh.points) {
    for (int axis = 0; axis < 3; ++axis) {
      std::array<char, 64> number;
      std::snprintf(number.data(), number.size(), format, p[axis]);
      text += std::string(number.data()) + (axis < 2 ? " " : "\n");
    }
  }
  for (const model::Loop& face : mesh.faces) {
    text += std::to_string(face.size());
    for (const std::uint32_t corner : face) text += " " + std::to_string(corner);
    text += "\n";
  }
  return text;
}

Solid import_text(const std::string& off, std::optional<double> flat_tolerance = {}) {
  ImportOptions options;
  options.flat_tolerance = flat_tolerance;
  return import_solid(parse_mesh(MeshFormat::Off, off, "it"), "it", options);
}

/// What corners may move by: half a unit along each axis, and a quarter more.
double most_move(const Solid& solid) {
  const FlatToleranceTaken& taken = solid.report.flat_tolerance;
  return std::max(2 * taken.spread, 1.25 * 0.5 * glm::length(taken.rounding));
}

/// Cells of a grid, those that are full -> the faces between full and empty, each a square.
/// REQUIRES: full cells that meet do so in a face.
PolygonMesh columns(const std::vector<std::vector<int>>& heights, glm::dvec3 unit) {
  PolygonMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto corner = [&](int x, int y, int z) {
    const auto [entry, is_new] =
        numbers.try_emplace({x, y, z}, static_cast<std::uint32_t>(mesh.points.size()));
    if (is_new) mesh.points.push_back(unit * glm::dvec3(x, y, z));
    return entry->second;
  };
  const int nx = static_cast<int>(heights.size());
  const int ny = static_cast<int>(heights[0].size());
  const auto is_full = [&](int x, int y, int z) {
    return x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny &&
           z < heights[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)];
  };
  int top = 0;
  for (const auto& row : heights) top = std::max(top, *std::max_element(row.begin(), row.end()));
  for (int x = 0; x < nx; ++x) {
    for (int y = 0; y < ny; ++y) {
      for (int z = 0; z < top; ++z) {
        if (!is_full(x, y, z)) continue;
        const auto square = [&](std::array<int, 3> out, std::array<std::array<int, 3>, 4> at) {
          if (is_full(x + out[0], y + out[1], z + out[2])) return;
          model::Loop loop;
          for (const auto& c : at) loop.push_back(corner(x + c[0], y + c[1], z + c[2]));
          mesh.faces.push_back(loop);
        };
        square({0, 0, -1}, {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}});
        square({0, 0, 1}, {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}});
        square({0, -1, 0}, {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}});
        square({0, 1, 0}, {{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}});
        square({-1, 0, 0}, {{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}});
        square({1, 0, 0}, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}});
      }
    }
  }
  return mesh;
}

struct Format {
  const char* text;
  glm::dvec3 shift;
};

const Format kFormats[] = {
    {"%.4g", {0, 0, 0}},       {"%.5g", {0, 0, 0}},       {"%.6g", {0, 0, 0}},
    {"%.9g", {0, 0, 0}},       {"%.1f", {0, 0, 0}},       {"%.3f", {0, 0, 0}},
    {"%.3e", {0, 0, 0}},       {"%.5g", {1500, 2500, 0}}, {"%.6g", {1500, 2500, 0}},
    {"%.7g", {1e6, 1e6, 1e6}}, {"%.9g", {1e6, 1e6, 1e6}}, {"%.2f", {1e6, -1e6, 2e6}},
    {"%.9g", {5e5, 5e6, 120}}, {"%.4f", {5e5, 5e6, 120}},
};

// Of what rounding left, one in fifty at most looks by chance as if it had been rounded otherwise:
// few numbers, all in one decade, or many that end with zeros.
constexpr int kOneIn = 50;

/// Boxes that were imported, and those that have not six planes.
struct BoxCount {
  int boxes = 0;
  int wrong = 0;

  Solid import(const Format& format, const PolygonMesh& mesh) {
    Solid solid = import_text(print(mesh, format.text));
    ++boxes;
    if (solid.planes.size() != 6) {
      ++wrong;
      std::cout << format.text << " at " << format.shift.x << ": " << solid.planes.size()
                << " planes\n";
    }
    return solid;
  }
};

TEST(Rounding, TurnedBoxesHaveSixPlanesHoweverTheyAreWritten) {
  std::mt19937 random(1);
  BoxCount count;
  for (const Format& format : kFormats) {
    for (int i = 0; i < 40; ++i) {
      const PolygonMesh mesh =
          placed(with_middles(box({120, 80, 30})), random_turn(random), format.shift);
      const Solid solid = count.import(format, mesh);
      EXPECT_LT(solid.report.largest_move, most_move(solid));
    }
  }
  EXPECT_LE(count.wrong * kOneIn, count.boxes);
}

TEST(Rounding, BoxesTurnedAboutOneAxisHaveSixPlanes) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(0.1, 1.4);
  BoxCount count;
  for (const Format& format : kFormats) {
    for (int i = 0; i < 40; ++i) {
      const double a = angle(random);
      const glm::dmat3 turn({std::cos(a), std::sin(a), 0}, {-std::sin(a), std::cos(a), 0},
                            {0, 0, 1});
      const PolygonMesh mesh = placed(with_middles(box({120, 80, 30})), turn, format.shift);
      count.import(format, mesh);
    }
  }
  EXPECT_LE(count.wrong * kOneIn, count.boxes);
}

TEST(Rounding, ATurnedPieceHasThePlanesItHadBefore) {
  std::mt19937 random(3);
  const PolygonMesh piece = model::make_model("mechanical-piece");
  for (const Format& format : kFormats) {
    if (std::string(format.text) == "%.7g") continue;  // of 1e6: a unit for holes of 10
    for (int i = 0; i < 5; ++i) {
      const Solid solid =
          import_text(print(placed(piece, random_turn(random), format.shift), format.text));
      EXPECT_EQ(solid.planes.size(), 43u) << format.text << " " << format.shift.x << " " << i;
      EXPECT_LT(solid.report.largest_move, most_move(solid));
    }
  }
}

// Volatile, for g++ 12 leaves out such conversions where it makes two at a time.
double to_single(double value) {
  volatile float single = static_cast<float>(value);
  return double{single};
}

TEST(Rounding, SinglesFarFromTheOriginHaveTheirPlanes) {
  std::mt19937 random(4);
  for (const glm::dvec3 shift : {glm::dvec3(2500, 2500, 0), {5e5, 5e6, 120}, {1e6, 1e6, 1e6}}) {
    for (int i = 0; i < 40; ++i) {
      PolygonMesh mesh = placed(with_middles(box({120, 80, 30})), random_turn(random), shift);
      for (glm::dvec3& p : mesh.points) p = {to_single(p.x), to_single(p.y), to_single(p.z)};
      const PolygonSoup as_text = parse_mesh(MeshFormat::Off, print(mesh, "%.17g"), "it");
      EXPECT_EQ(as_text.precision.binary_digits, 24);
      EXPECT_EQ(import_solid(as_text, "it", {}).planes.size(), 6u) << shift.x << " " << i;
    }
  }
}

/// The planes with every digit meant, and unless anything is said.
void expect_to_keep_every_plane(const PolygonMesh& mesh, const char* format) {
  const std::string text = print(mesh, format);
  const Solid exact = import_text(text, 0);
  const Solid solid = import_text(text);
  EXPECT_EQ(solid.planes.size(), exact.planes.size()) << format;
  EXPECT_EQ(solid.report.largest_move, 0) << format;
}

TEST(Rounding, ModelsOfShortNumbersKeepEveryPlane) {
  for (const char* format : {"%g", "%.0f", "%.1f", "%.3f", "%.3e"}) {
    expect_to_keep_every_plane(with_middles(box({2, 2, 2})), format);
    expect_to_keep_every_plane(box({1, 1, 1}), format);
    expect_to_keep_every_plane(box({4500, 1200, 3750}), format);
  }
  expect_to_keep_every_plane(model::make_model("house-plan"), "%.0f");
  expect_to_keep_every_plane(model::make_model("city-block"), "%g");
}

// Steps of one unit of the last digit, all over a plate.
TEST(Rounding, StepsOfOneUnitStay) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> height(1, 3);
  for (int i = 0; i < 20; ++i) {
    std::vector<std::vector<int>> heights(4, std::vector<int>(4));
    for (auto& row : heights) {
      for (int& h : row) h = height(random);
    }
    // No two columns that meet in an edge only: rows differ by steps in one direction.
    for (auto& row : heights) std::sort(row.begin(), row.end());
    std::sort(heights.begin(), heights.end());
    for (std::size_t x = 1; x < 4; ++x) {
      for (std::size_t y = 0; y < 4; ++y) {
        heights[x][y] = std::max(heights[x][y], heights[x - 1][y]);
      }
    }
    expect_to_keep_every_plane(columns(heights, {25, 25, 0.1}), "%.1f");
    expect_to_keep_every_plane(columns(heights, {31.7, 23.3, 0.1}), "%.1f");
    expect_to_keep_every_plane(columns(heights, {17.123, 23.377, 0.001}), "%.3f");
    expect_to_keep_every_plane(columns(heights, {617, 1, 523}), "%.0f");
  }
}

// A cylinder with a flat on it one unit deep, its axis along z: its rim is rounded, its ends and
// sides are exact.
TEST(Rounding, APartWithAStepOfTheLastDigitKeepsIt) {
  PolygonMesh mesh;
  constexpr std::uint32_t kSides = 24;
  // Three rings: a shoulder of 0.001 between the second and the third.
  const double heights[] = {0, 20, 20.001};
  const double radii[] = {50, 50, 30};
  model::Loop bottom;
  model::Loop top;
  std::array<model::Loop, 4> rings;
  const std::array<std::array<double, 2>, 4> at = {{{radii[0], heights[0]},
                                                    {radii[1], heights[1]},
                                                    {radii[2], heights[1]},
                                                    {radii[2], heights[2]}}};
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double angle = 2 * std::acos(-1.0) * i / kSides + 0.1;
      rings[r].push_back(static_cast<std::uint32_t>(mesh.points.size()));
      mesh.points.push_back({at[r][0] * std::cos(angle), at[r][0] * std::sin(angle), at[r][1]});
    }
  }
  for (std::size_t r = 0; r + 1 < 4; ++r) {
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t j = (i + 1) % kSides;
      mesh.faces.push_back({rings[r][i], rings[r][j], rings[r + 1][j], rings[r + 1][i]});
    }
  }
  mesh.faces.push_back({rings[0].rbegin(), rings[0].rend()});
  mesh.faces.push_back(rings[3]);
  const Solid solid = import_text(print(mesh, "%.3f"));
  // Bottom, shoulder, top, the sides, and those of the step (each parallel to a side).
  EXPECT_EQ(solid.planes.size(), 3 + 2 * kSides);
}

// Where rounding hides the facets, corners still move no farther than it explains.
TEST(Rounding, CurvedSurfacesMoveNoFartherThanRoundingExplains) {
  std::mt19937 random(6);
  for (const auto& [name, size] :
       {std::pair("cylinder", 64), {"cylinder", 500}, {"wavy-sphere", 24}, {"sphere", 40}}) {
    for (const char* format : {"%.4g", "%.5g", "%.1f"}) {
      const PolygonMesh mesh =
          placed(model::make_model(name, size), random_turn(random), {0, 0, 0});
      Solid solid;
      try {
        solid = import_text(print(mesh, format));
      } catch (const BadInput&) {
        continue;  // facets smaller than a unit
      }
      EXPECT_LT(solid.report.largest_move, most_move(solid)) << name << size << format;
    }
  }
}

TEST(Rounding, ACylinderOfAHundredSidesInFourDigitsKeepsItsSides) {
  std::mt19937 random(7);
  for (int i = 0; i < 5; ++i) {
    const PolygonMesh mesh =
        placed(model::make_model("cylinder", 48), random_turn(random), {0, 0, 0});
    const Solid solid = import_text(print(mesh, "%.4g"));
    EXPECT_EQ(solid.planes.size(), 50u) << i;
  }
}

}  // namespace
}  // namespace spoctree
