// What readers record of how finely files write their coordinates, against the formats that wrote
// them: printf's own, with random numbers.
#include "server/mesh/precision.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <random>

#include "server/mesh/read_mesh.hpp"
#include "tests/unit/mesh/mesh_test_support.hpp"

namespace spoctree {
namespace {

using Points = std::vector<glm::dvec3>;

Points random_points(int count, glm::dvec3 middle, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-size, size);
  Points points;
  for (int i = 0; i < count; ++i) {
    points.push_back(middle + glm::dvec3(number(random), number(random), number(random)));
  }
  return points;
}

std::string print(const char* format, double value) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// What the record says of the points, printed so.
Precision precision_of(const Points& points, const char* format) {
  DigitRecord record;
  for (const glm::dvec3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::string text = print(format, p[axis]);
      record.add(axis, text, std::stod(text));
    }
  }
  return record.precision();
}

Points as_singles(Points points) {
  for (glm::dvec3& p : points) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<float>(p[axis]);
  }
  return points;
}

TEST(Precision, SpacingIsTheLargestThatALimitMakesIt) {
  EXPECT_EQ((Precision{.decimal_digits = 4}.spacing_at(123.4)), 0.1);
  EXPECT_EQ((Precision{.decimal_digits = 4}.spacing_at(-99.99)), 0.01);
  EXPECT_EQ((Precision{.decimal_digits = 6}.spacing_at(1e6)), 10);
  EXPECT_EQ((Precision{.decimal_digits = 6}.spacing_at(999999)), 1);
  EXPECT_EQ((Precision{.unit = 0.001}.spacing_at(5e5)), 0.001);
  EXPECT_EQ((Precision{.unit = 0.001}.spacing_at(0)), 0.001);
  EXPECT_EQ((Precision{.binary_digits = 24}.spacing_at(500000)), 0.03125);
  EXPECT_EQ((Precision{.binary_digits = 24}.spacing_at(5e6)), 0.5);
  EXPECT_EQ((Precision{.unit = 0.001, .binary_digits = 24}.spacing_at(5e6)), 0.5);
  EXPECT_EQ(Precision{}.spacing_at(1), 0x1p-52);
  EXPECT_EQ(Precision{}.spacing_at(0), 0);
}

TEST(DigitRecord, FindsTheSignificantDigitsOfNumbersWithoutTheirZeros) {
  for (const glm::dvec3 middle : {glm::dvec3(0, 0, 0), glm::dvec3(30, 200, 2500)}) {
    const Points points = random_points(14, middle, 120, 1);
    EXPECT_EQ(precision_of(points, "%.4g").decimal_digits, 4);
    EXPECT_EQ(precision_of(points, "%.5g").decimal_digits, 5);
    EXPECT_EQ(precision_of(points, "%.6g").decimal_digits, 6);
    EXPECT_EQ(precision_of(points, "%.9g").decimal_digits, 9);
    EXPECT_EQ(precision_of(points, "%.3e").decimal_digits, 4);
  }
}

TEST(DigitRecord, TellsTheUnitOfLargeCoordinates) {
  const Points points = random_points(14, {1e6, 2.5e6, 1.2e6}, 120, 2);
  const auto spacing = [&](const char* format) {
    return coordinate_spacing(precision_of(points, format), points);
  };
  EXPECT_EQ(spacing("%.6g"), glm::dvec3(10, 10, 10));
  EXPECT_EQ(spacing("%.7g"), glm::dvec3(1, 1, 1));
  EXPECT_EQ(spacing("%.9g"), glm::dvec3(0.01, 0.01, 0.01));
  EXPECT_EQ(spacing("%.2f"), glm::dvec3(0.01, 0.01, 0.01));
  EXPECT_EQ(spacing("%.5e"), glm::dvec3(10, 10, 10));
}

TEST(DigitRecord, FindsTheUnitOfNumbersWithAFixedPoint) {
  for (const double size : {0.5, 30.0, 500.0}) {
    const Points points = random_points(14, {0, 0, 0}, size, 3);
    for (const char* format : {"%.3f", "%10.3f", "%+.3f"}) {
      const Precision found = precision_of(points, format);
      EXPECT_EQ(found.unit, 0.001) << format << size;
      EXPECT_EQ(found.decimal_digits, 0) << format << size;
    }
  }
}

TEST(DigitRecord, ZerosThatAreWrittenCount) {
  EXPECT_EQ(precision_of({{100, 50, 0}, {0, 20, 10}}, "%.3f").unit, 0.001);
  EXPECT_EQ(precision_of({{100, 50, 0}, {0, 20, 10}}, "%.3e").decimal_digits, 4);
}

TEST(DigitRecord, ShortNumbersHaveTheUnitOfTheLongestOfThem) {
  const Points cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
  EXPECT_EQ(precision_of(cube, "%g").unit, 1);
  EXPECT_EQ(precision_of(cube, "%.6f").unit, 1e-6);
  // What a designer writes: no rounding to so many digits.
  const Points part = {{100, 0.125, 12.5}, {1000, 12.25, 50}, {1000, 20, 6.35}, {25.4, 0.05, 3}};
  EXPECT_EQ(precision_of(part, "%g").unit, 0.001);
  const Points plate = {{0, 0, 0}, {100, 0, 1}, {100, 50, 1.1}, {100, 100, 1.1}};
  EXPECT_EQ(precision_of(plate, "%g").unit, 0.1);
}

TEST(DigitRecord, OneAxisThatIsWrittenInFullIsEnough) {
  Points points = random_points(20, {0, 0, 0}, 120, 4);
  for (glm::dvec3& p : points) p.z = p.z < 0 ? 0 : 10;
  EXPECT_EQ(precision_of(points, "%.5g").decimal_digits, 5);
}

TEST(DigitRecord, NumbersThatWereSinglesHaveTheirSpacing) {
  for (const glm::dvec3 middle : {glm::dvec3(0, 0, 0), glm::dvec3(5e5, 5e6, 100)}) {
    const Points points = as_singles(random_points(20, middle, 120, 5));
    for (const char* format : {"%.9g", "%.17g", "%.12f"}) {
      EXPECT_EQ(precision_of(points, format).binary_digits, 24) << format;
    }
    EXPECT_EQ(precision_of(random_points(20, middle, 120, 5), "%.17g").binary_digits, 53);
    EXPECT_EQ(precision_of(random_points(20, middle, 120, 5), "%.9g").binary_digits, 53);
  }
  // Short ones say nothing.
  EXPECT_EQ(precision_of({{0.5, 100, 3}, {2, 4, 8}}, "%g").binary_digits, 53);
}

TEST(DigitRecord, PassesOverWhatIsNoNumber) {
  DigitRecord record;
  for (const char* word : {"", "-", ".", "e", "1e", "1e-99999999999999", "...", "0e5", "1E+0x"}) {
    record.add(0, word, 0);
  }
  EXPECT_GE(record.precision().unit, 0);
}

TEST(BitRecord, TellsSinglesInDoublesFromShortDoubles) {
  BitRecord singles;
  BitRecord doubles;
  BitRecord wholes;
  for (const glm::dvec3& p : random_points(20, {0, 0, 0}, 120, 6)) {
    doubles.add_double(p.x);
    singles.add_double(static_cast<double>(static_cast<float>(p.x)));
    wholes.add_double(std::round(p.x));
  }
  EXPECT_EQ(singles.precision().binary_digits, 24);
  EXPECT_EQ(doubles.precision().binary_digits, 53);
  EXPECT_EQ(wholes.precision().binary_digits, 53);
}

TEST(Precision, EveryReaderRecordsThePrecision) {
  using namespace mesh_test;
  EXPECT_EQ(parse_mesh(MeshFormat::Off, kTetrahedronOff, "it").precision.unit, 1);
  EXPECT_EQ(parse_mesh(MeshFormat::Obj, kTetrahedronObj, "it").precision.unit, 1);
  EXPECT_EQ(parse_mesh(MeshFormat::Stl, kTetrahedronTextStl, "it").precision.unit, 1);
  EXPECT_EQ(parse_mesh(MeshFormat::Ply, kTetrahedronTextPly, "it").precision.unit, 1);
  EXPECT_EQ(parse_mesh(MeshFormat::Stl, tetrahedron_binary_stl(), "it").precision.binary_digits,
            24);
  const std::string ply = tetrahedron_binary_ply(ByteOrder::BigEndian);
  EXPECT_EQ(parse_mesh(MeshFormat::Ply, ply, "it").precision.binary_digits, 24);
  EXPECT_EQ(parse_mesh(MeshFormat::Off,
                       "4OFF\n4 4 6\n0 0 0 3\n1 0 0 3\n0 1 0 3\n0 0 1 3\n"
                       "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
                       "it")
                .precision.unit,
            0);
}

TEST(Precision, DroppingCollapsedFacesKeepsThePrecision) {
  const std::string text =
      "OFF\n5 5 0\n0 0 0\n1.5 0 0\n0 1 0\n0 0 1\n0 0 0\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
      "3 0 4 1\n";
  const PolygonSoup soup = parse_mesh(MeshFormat::Off, text, "it");
  EXPECT_EQ(soup.collapsed.count, 1u);
  EXPECT_EQ(soup.precision.unit, 0.1);
}

}  // namespace
}  // namespace spoctree
