// Families of solids that rounding, or cuts that do not meet, have taken apart: repair gives them
// back, with the volume that is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "common/base/errors.hpp"
#include "server/solid/import_solid.hpp"
#include "server/solid/repair.hpp"
#include "tests/support/fragments.hpp"
#include "tests/support/random.hpp"

namespace spoctree {
namespace {

struct Taken {
  int refused = 0;
};

/// Whether the soup is a solid after repair; its volume then has to be right.
void expect_repaired(const PolygonSoup& soup, double volume, double tolerance, Taken& taken,
                     const std::string& which) {
  const Repair repaired = repair(soup);
  ImportOptions options;
  options.turn_shells = true;
  try {
    const Solid solid = import_solid(repaired.soup, which, options);
    EXPECT_NEAR(solid.volume / volume, 1, tolerance) << which;
  } catch (const BadInput& error) {
    // Pieces thinner than the digits can fold over each other.
    ++taken.refused;
    EXPECT_NE(std::string(error.what()).find("self-intersecting"), std::string::npos)
        << error.what();
  }
}

void expect_cut_cubes_whole(int most_cuts, bool along_axes) {
  Taken taken;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random random(seed);
    const FragmentSolid solid = random_cubes(3, random);
    const int cuts = 1 + static_cast<int>(seed % static_cast<std::uint64_t>(most_cuts));
    std::vector<Fragment> pieces = cut_at_random(solid.faces, cuts, along_axes, random);
    const std::string which = "cubes " + std::to_string(seed);
    expect_repaired(soup_of(pieces, seed % 2 == 0), solid.volume, 1e-12, taken, which);
    round_to_digits(pieces, 6);
    Precision precision;
    precision.decimal_digits = 6;
    expect_repaired(soup_of(pieces, seed % 2 == 0, precision), solid.volume, 1e-5, taken,
                    which + ", 6 digits");
  }
  EXPECT_EQ(taken.refused, 0);
}

TEST(RepairProperty, CubesCutAlongTheAxesAreWhole) { expect_cut_cubes_whole(5, true); }
TEST(RepairProperty, CubesCutInAnyDirectionAreWhole) { expect_cut_cubes_whole(4, false); }

TEST(RepairProperty, PrismsCutInAnyDirectionAreWhole) {
  Taken taken;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const FragmentSolid solid = random_prism(3 + static_cast<int>(seed % 9), random);
    std::vector<Fragment> pieces =
        cut_at_random(solid.faces, 1 + static_cast<int>(seed % 4), false, random);
    const std::string which = "prism " + std::to_string(seed);
    expect_repaired(soup_of(pieces, seed % 2 == 0), solid.volume, 1e-12, taken, which);
    round_to_digits(pieces, 6);
    Precision precision;
    precision.decimal_digits = 6;
    expect_repaired(soup_of(pieces, seed % 2 == 0, precision), solid.volume, 1e-4, taken,
                    which + ", 6 digits");
  }
  EXPECT_LE(taken.refused, 1);
}

TEST(RepairProperty, CornersThatDifferByAnyNoiseAreOne) {
  Taken taken;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const FragmentSolid solid = seed % 2 == 0
                                    ? random_cubes(3, random)
                                    : random_prism(3 + static_cast<int>(seed % 9), random);
    for (const double amount : {1e-16, 1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5}) {
      std::vector<Fragment> pieces = solid.faces;
      add_noise(pieces, amount, random);
      expect_repaired(soup_of(pieces, true), solid.volume, 1e-12 + 20 * amount, taken,
                      "noise " + std::to_string(seed) + " of " + std::to_string(amount));
    }
  }
  EXPECT_EQ(taken.refused, 0);
}

TEST(RepairProperty, NothingDependsOnTheOrderOfFacesOrPoints) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const FragmentSolid solid = random_cubes(3, random);
    std::vector<Fragment> pieces = cut_at_random(solid.faces, 3, false, random);
    add_noise(pieces, 1e-9, random);
    std::vector<std::array<double, 3>> places[2];
    for (auto& of : places) {
      const PolygonSoup soup = repair(soup_of(pieces, false)).soup;
      for (const glm::dvec3& p : soup.points) of.push_back({p.x, p.y, p.z});
      std::sort(of.begin(), of.end());
      for (std::size_t i = pieces.size(); i > 1; --i) {
        std::swap(pieces[i - 1], pieces[random.below(static_cast<std::uint32_t>(i))]);
      }
      for (Fragment& piece : pieces) {
        std::rotate(piece.begin(), piece.begin() + 1, piece.end());
      }
    }
    EXPECT_EQ(places[0], places[1]) << seed;
  }
}

}  // namespace
}  // namespace spoctree
