// The universe cube and its grid, judged by rational numbers.
#include "common/geometry/universe.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "common/base/errors.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/grid_planes.hpp"

namespace spoctree {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Rational power_of_two(int exponent) {
  using boost::multiprecision::cpp_int;
  return exponent >= 0 ? Rational(cpp_int(1) << exponent) : 1 / Rational(cpp_int(1) << -exponent);
}

/// The exact half side of the cube in model units.
Rational half_side_of(const Universe& universe) {
  return Rational(universe.half_side) * power_of_two(universe.scale_exponent);
}

/// The smallest exact distance from the box to the cube's walls, model units; negative if outside.
Rational margin(const Universe& universe, Vec3 lower, Vec3 upper) {
  const Rational half = half_side_of(universe);
  Rational smallest = 3 * half;
  for (int axis = 0; axis < 3; ++axis) {
    const Rational center(universe.center[axis]);
    for (const Rational& gap : {Rational(Rational(lower[axis]) - (center - half)),
                                Rational((center + half) - Rational(upper[axis]))}) {
      if (gap < smallest) smallest = gap;
    }
  }
  return smallest;
}

TEST(UniverseAround, IsLargerThanTheBoxByAHairAndContainsItWithAMargin) {
  Random random(1);
  for (int k = 0; k < 2000; ++k) {
    const double size = std::ldexp(random.between(1, 2), random_integer(random, -60, 60));
    const Vec3 lower = random_vector(random, 100 * size);
    Vec3 extent = Vec3{random.unit(), random.unit(), random.unit()} * size;
    extent[random_integer(random, 0, 2)] = size;
    const Vec3 upper = lower + extent;
    const Universe universe = universe_around(lower, upper);
    ASSERT_TRUE(is_valid(universe));
    Rational largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Rational side = Rational(upper[axis]) - Rational(lower[axis]);
      if (side > largest) largest = side;
    }
    const Rational side = 2 * half_side_of(universe);
    EXPECT_GE(side, largest * Rational(1002, 1000));
    EXPECT_LE(side, largest * Rational(1005, 1000));
    EXPECT_GE(margin(universe, lower, upper), largest * Rational(1, 1000));
    // Off centre on every axis, by less than the hair.
    for (int axis = 0; axis < 3; ++axis) {
      const Rational middle = (Rational(lower[axis]) + Rational(upper[axis])) / 2;
      const Rational shift = Rational(universe.center[axis]) - middle;
      EXPECT_GT(shift, largest / 10000);
      EXPECT_LT(shift, largest / 2000);
    }
  }
}

TEST(UniverseAround, IsValidWhereTheEnlargedSideIsAPowerOfTwo) {
  // 512 / 257 enlarged by 1 / 256 and halved is 1: the half side must not come out as 0.5 * 2^1.
  double side = 512.0 / 257;
  for (int k = 0; k < 20; ++k) side = std::nextafter(side, 0.0);
  for (int k = 0; k < 40; ++k, side = std::nextafter(side, 3.0)) {
    for (const int exponent : {-40, 0, 17}) {
      const double scaled = std::ldexp(side, exponent);
      const Universe universe = universe_around(Vec3{0.0}, Vec3{scaled});
      EXPECT_TRUE(is_valid(universe)) << universe.half_side;
      EXPECT_GT(margin(universe, Vec3{0.0}, Vec3{scaled}), 0);
    }
  }
}

TEST(UniverseAround, ContainsBoxesFarFromTheOrigin) {
  for (const double offset : {1e3, 1e6, 1e9, 1e12, 1e15, 9007199254740993.0, 1e16, 1e17, 1e20}) {
    for (const double sign : {-1.0, 1.0}) {
      for (int steps = 1; steps < 40; ++steps) {
        Vec3 lower{sign * offset, 0.0, 0.0};
        Vec3 upper = lower;
        for (int k = 0; k < steps; ++k) upper.x = std::nextafter(upper.x, kInfinity);
        const double size = upper.x - lower.x;
        upper.y = size / 3;
        const Universe universe = universe_around(lower, upper);
        ASSERT_TRUE(is_valid(universe));
        EXPECT_GT(margin(universe, lower, upper), Rational(size) / 2000)
            << offset << " + " << steps << " steps";
        for (const Vec3 corner : {lower, upper}) {
          const Vec3 y = universe.to_grid(corner);
          EXPECT_EQ(universe.to_model(y).x, corner.x);
        }
      }
    }
  }
}

TEST(UniverseAround, TakesBoxesOfEverySaneSizeAndRefusesOthers) {
  for (int exponent = -899; exponent <= 898; ++exponent) {
    const Vec3 corner{std::ldexp(1.5, exponent), 0.0, 0.0};
    const Universe universe = universe_around(Vec3{0.0}, corner);
    ASSERT_TRUE(is_valid(universe)) << exponent;
    EXPECT_GT(margin(universe, Vec3{0.0}, corner), 0) << exponent;
    EXPECT_TRUE(std::isfinite(universe.diagonal()));
    EXPECT_GT(universe.diagonal(), 0);
  }
  // A tiny box very far away: the cube is as large as the doubles there are coarse.
  const Vec3 far{0x1p800, 0.0, 0.0};
  EXPECT_GT(
      margin(universe_around(far, far + Vec3{0, 0x1p-800, 0}), far, far + Vec3{0, 0x1p-800, 0}), 0);
  EXPECT_THROW(universe_around(Vec3{1.0}, Vec3{1.0}), BadInput);
  EXPECT_THROW(universe_around(Vec3{0.0}, Vec3{5e-324}), BadInput);
  EXPECT_THROW(universe_around(Vec3{0.0}, Vec3{1e-300}), BadInput);
  EXPECT_THROW(universe_around(Vec3{-1e308}, Vec3{1e308}), BadInput);
  EXPECT_THROW(universe_around(Vec3{-1.7e308}, Vec3{1.7e308}), BadInput);
}

TEST(UniverseAround, IsTheSameCubeWhateverTheScale) {
  // Scaling by a power of two changes nothing but the exponent.
  const Vec3 lower{-1.25, 0.3, 7.0};
  const Vec3 upper{2.75, 0.9, 7.5};
  const Universe one = universe_around(lower, upper);
  for (const int exponent : {-300, -20, 3, 300}) {
    const double factor = std::ldexp(1.0, exponent);
    const Universe other = universe_around(lower * factor, upper * factor);
    EXPECT_EQ(other.half_side, one.half_side);
    EXPECT_EQ(other.center, one.center * factor);
    EXPECT_EQ(other.scale_exponent, one.scale_exponent + exponent);
  }
}

TEST(Universe, WallsOfEveryDepthLieOnTheGrid) {
  Random random(2);
  for (int k = 0; k < 2000; ++k) {
    const double half_side = std::ldexp((1 << 19) + 1 + random.below(1 << 19), -kHalfSideBits);
    for (const std::uint32_t index :
         {0u, 1u, (1u << 30) - 1, 1u << 30, 1u << 29, random.below(1u << 30)}) {
      const double wall = wall_coordinate(half_side, index);
      const Rational expected =
          Rational(half_side) * (Rational(index) / power_of_two(kMaxDepth - 1) - 1);
      EXPECT_EQ(Rational(wall), expected);
      EXPECT_EQ(denominator(Rational(wall) * power_of_two(kGridBits)), 1);
    }
    EXPECT_EQ(wall_coordinate(half_side, 0), -half_side);
    EXPECT_EQ(wall_coordinate(half_side, 1u << 29), 0);
    EXPECT_EQ(wall_coordinate(half_side, 1u << 30), half_side);
  }
}

TEST(Universe, RoundsToTheNearestGridPoint) {
  Random random(3);
  for (int k = 0; k < 5000; ++k) {
    const Vec3 lower = random_vector(random, 5);
    const Vec3 extent{1, 1, random.between(0.5, 2)};
    const Universe universe = universe_around(lower, lower + extent);
    const Vec3 x = lower + extent * Vec3{random.unit(), random.unit(), random.unit()};
    const Vec3 y = universe.to_grid(x);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(denominator(Rational(y[axis]) * power_of_two(kGridBits)), 1);
      const Rational exact = (Rational(x[axis]) - Rational(universe.center[axis])) /
                             power_of_two(universe.scale_exponent);
      // Half a step for the grid, as much again for the rounding of x - center.
      EXPECT_LE(abs(Rational(Rational(y[axis]) - exact)), power_of_two(-kGridBits));
      EXPECT_LE(std::abs(y[axis]), universe.half_side);
    }
  }
}

TEST(Universe, BringsSinglePrecisionCoordinatesBackExactly) {
  Random random(4);
  for (int k = 0; k < 300; ++k) {
    const double size = std::ldexp(random.between(1, 2), random_integer(random, -20, 20));
    // The box may lie off the origin by up to a thousand times its size.
    const Vec3 lower = Vec3(glm::vec3(random_vector(random, size * (k % 3 == 0 ? 1000 : 1))));
    const Vec3 upper = Vec3(glm::vec3(lower + Vec3{size}));
    const Universe universe = universe_around(lower, upper);
    for (int i = 0; i < 100; ++i) {
      glm::vec3 x(lower + random_vector(random, 0.5) * size + 0.5 * size);
      // Nearer to 0 than that, floats are finer than the grid.
      const double finest = std::ldexp(universe.scale(), -kGridBits + 24);
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(static_cast<double>(x[axis])) < finest) x[axis] = 0;
      }
      EXPECT_EQ(universe.to_model(universe.to_grid(Vec3(x))), Vec3(x));
    }
  }
}

TEST(Universe, OfAnyDoublesMovesNoPointByMoreThanAGridStep) {
  Random random(5);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 lower = random_vector(random, 1000);
    const Vec3 upper = lower + Vec3{random.between(0.001, 1000)};
    const Universe universe = universe_around(lower, upper);
    const Vec3 x = lower + (upper - lower) * random.unit();
    const Vec3 back = universe.to_model(universe.to_grid(x));
    for (int axis = 0; axis < 3; ++axis) {
      const double ulp = std::abs(std::nextafter(x[axis], kInfinity) - x[axis]);
      EXPECT_LE(std::abs(back[axis] - x[axis]), std::max(universe.scale() * 0x1p-52, ulp));
    }
  }
}

TEST(IsValidUniverse, RefusesEveryValueOutOfItsRange) {
  const Universe good = universe_around(Vec3{0.0}, Vec3{1.0});
  ASSERT_TRUE(is_valid(good));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double value : {kNaN, kInfinity, -kInfinity}) {
      Universe bad = good;
      bad.center[axis] = value;
      EXPECT_FALSE(is_valid(bad));
    }
  }
  for (const double value : {kNaN, kInfinity, -kInfinity, 0.0, -0.75, 0.5, 0.499, 1.0 + 0x1p-20,
                             2.0, 0.75 + 0x1p-21, 0.75 + 0x1p-52}) {
    Universe bad = good;
    bad.half_side = value;
    EXPECT_FALSE(is_valid(bad)) << value;
  }
  for (const double value : {0.5 + 0x1p-20, 0.75, 1.0, 1.0 - 0x1p-20}) {
    Universe fine = good;
    fine.half_side = value;
    EXPECT_TRUE(is_valid(fine)) << value;
  }
  for (const int exponent :
       {-1001, 1001, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
    Universe bad = good;
    bad.scale_exponent = exponent;
    EXPECT_FALSE(is_valid(bad));
  }
}

}  // namespace
}  // namespace spoctree
