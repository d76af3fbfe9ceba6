// What is known of every model by construction, not from the generator's output.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace spoctree::model {

struct Expectation {
  std::string name;
  std::optional<int> size;
  std::size_t shells;
  long genus;  // of all shells together
  std::size_t planes;
  double volume;  // mm^3
};

inline void PrintTo(const Expectation& expected, std::ostream* out) {
  *out << expected.name;
  if (expected.size) *out << ' ' << *expected.size;
}

inline double mechanical_piece_volume() {
  // Seen from above: rectangle, two cut corners, the slot (a rectangle, then a trapezoid), two bolt
  // holes (two trapezoids each).
  const double base_area = 120 * 70 - 2 * (12 * 12 / 2.0) - (16 * 10 + (16 + 8) / 2.0 * 4) -
                           2 * (2 * (20 + 10) / 2.0 * 9);
  // The bevel takes a height of 6 - 2y from the front edge for y from 0 to 3, over a width that
  // grows with the cut corners from 96 to 102, less the slot's 16:
  // integral of (6 - 2y)(80 + 2y) = 480 y - 74 y^2 - 4/3 y^3.
  const double bevel = 480 * 3 - 74 * 9 - 4.0 / 3 * 27;
  const double base = 14 * base_area - bevel;
  const double step = 120 * 30 * 6;  // as far as the back, below the upright, too
  // Seen from the front: two trapezoids above z = 20, less a square with its corners cut off.
  const double bore = 28 * 28 - 4 * (8.2 * 8.2 / 2);
  const double upright = 18 * ((120 + 52) / 2.0 * 44 + (52 + 24) / 2.0 * 14 - bore);
  const double rib = 10 * (30 * 20 / 2.0 - 12 * 6);  // a triangle, less what is inside the step
  return base + step + upright + rib;
}

inline double regular_polygon_area(int sides, double radius) {
  return sides / 2.0 * radius * radius * std::sin(2 * std::numbers::pi / sides);
}

/// Frustums of pyramids between similar polygons: h / 3 (A + B + sqrt(A B)).
inline double sphere_volume(int bands) {
  double sum = 0;
  for (int i = 0; i < bands; ++i) {
    const double low = std::numbers::pi * i / bands;
    const double high = std::numbers::pi * (i + 1) / bands;
    const double a = regular_polygon_area(2 * bands, 50 * std::sin(low));
    const double b = regular_polygon_area(2 * bands, 50 * std::sin(high));
    sum += 50 * (std::cos(low) - std::cos(high)) / 3 * (a + b + std::sqrt(a * b));
  }
  return sum;
}

/// Tetrahedra from the middle: each band's trapezoids are split from their low left corner.
inline double wavy_sphere_volume(int bands) {
  struct Point {
    double x, y, z;
  };
  const auto point = [bands](int band, int sector) {
    const double from_south = std::numbers::pi * band / bands;
    const double east = std::numbers::pi * sector / bands;
    const Point u{std::sin(from_south) * std::cos(east), std::sin(from_south) * std::sin(east),
                  -std::cos(from_south)};
    const double r = 50 + 2.5 * std::sin(9 * u.x) * std::sin(8 * u.y) * std::sin(7 * u.z);
    return Point{r * u.x, r * u.y, r * u.z};
  };
  const auto tetrahedron = [](Point a, Point b, Point c) {
    return (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
            a.z * (b.x * c.y - b.y * c.x)) /
           6;
  };
  double sum = 0;
  for (int i = 0; i < bands; ++i) {
    for (int k = 0; k < 2 * bands; ++k) {
      const Point a = point(i, k), b = point(i, k + 1), c = point(i + 1, k + 1),
                  d = point(i + 1, k);
      // At the poles one of the two has no area.
      sum += tetrahedron(a, b, c) + tetrahedron(a, c, d);
    }
  }
  return sum;
}

inline std::vector<Expectation> expectations() {
  std::vector<Expectation> all{
      // The planes of the first are those of image 2 of the paper.
      {"mechanical-piece", {}, 1, 3, 43, mechanical_piece_volume()},
      {"cube", {}, 1, 0, 6, 100.0 * 100 * 100},
      {"octahedron", {}, 1, 0, 8, 4.0 / 3 * 50 * 50 * 50},
      // A cube of 50 mm, and on each of its faces a pyramid of a sixth of it.
      {"diamond", {}, 1, 0, 12, 2 * 50.0 * 50 * 50},
      {"l-bracket", {}, 1, 0, 8, 40.0 * (80 * 20 + 20 * 40)},
      // The windows' long walls share their planes: 6 + 2 + 2 * 2.
      {"double-torus", {}, 1, 2, 12, 20.0 * (100 * 60 - 2 * 20 * 20)},
      {"nested-boxes", {}, 4, 0, 24, 1e6 - 60.0 * 60 * 60 + 30.0 * 30 * 30 - 10.0 * 10 * 10},
      {"two-parts", {}, 2, 0, 14, 40.0 * 40 * 40 + 4.0 / 3 * 25 * 25 * 25},
      // Four triangular prisms over 1600 mm^2 each, corners 40, 60 and 20 mm high.
      // Planes: 6 outside, 10 of the rooms, 5 of the doors, 4 of the hatch.
      {"house-plan",
       {},
       2,
       1,
       25,
       1e9 * (10 * 8 * 2.9 - 5.8 * 7.6 * 2.5 - 2 * 3.6 * 3.7 * 2.5 - 0.2 * 2.2 * 2.0 -
              1.4 * 0.2 * 0.8)},
      // Planes: 9 and 8 across x, 10 and 10 across y, 13 across z.
      {"city-block",
       {},
       1,
       1,
       50,
       1e9 * (60 * 60 * 0.5 + 12 * 24 * 15 + 12 * 10 * 30 + 20 * 12 * 12 + 8 * 16 * 21 +
              12 * 18 * 18 - 12 * 4 * 5 + 8 * 6 * 9 + 22 * 8 * 24 + 10 * 8 * 9 + 10 * 8 * 18 +
              4 * 4 * 2 + 2 * 2 * 8)},
      {"saddle", {}, 1, 0, 9, 4 * 1600.0 * (40 + 60 + 20) / 3},
      // Figure 11 of the paper on silhouettes, in units of 50 mm; the wedge is not what it states.
      {"slice", {}, 1, 0, 6, 2.0 * 125000},
      {"pyramid", {}, 1, 0, 5, 8.0 / 3 * 125000},
      {"wedge", {}, 1, 0, 6, 40.0 / 3 * (50 * 50 + 10 * 10 + 50 * 10)},
      {"octagonal-prism", {}, 1, 0, 10, 16 * (std::numbers::sqrt2 - 1) * 125000},
      {"rectangular-prism", {}, 1, 0, 6, 2.0 * 125000},
      {"arc",
       {},
       1,
       0,
       2 * 16 + 4,
       25 * (regular_polygon_area(64, 50) - regular_polygon_area(64, 25)) / 4},
      {"small-cube", {}, 1, 0, 6, 12.5 * 12.5 * 12.5},
      // The plate has 6 planes; the posts share theirs: 4 across x, 4 across y, one on top.
      {"self-occluding",
       {},
       1,
       0,
       6 + 9 + 32 + 1,
       100.0 * 100 * 10 + 4 * 20.0 * 20 * 90 + 75 * regular_polygon_area(32, 18)},
      {"sphere", {}, 1, 0, 2 * 16 * 16, sphere_volume(16)},
      {"wavy-sphere", {}, 1, 0, 4 * 16 * 15, wavy_sphere_volume(16)},
      {"wavy-sphere", 7, 1, 0, 4 * 7 * 6, wavy_sphere_volume(7)},
      {"cylinder", {}, 1, 0, 32 + 2, 100 * regular_polygon_area(32, 50)},
      {"cone", {}, 1, 0, 32 + 1, 100 * regular_polygon_area(32, 50) / 3},
  };
  for (const int n : {3, 4, 7, 20}) {
    const auto count = static_cast<std::size_t>(n);
    all.push_back({"sphere", n, 1, 0, 2 * count * count, sphere_volume(n)});
  }
  for (const int n : {3, 4, 7, 100}) {
    const auto count = static_cast<std::size_t>(n);
    all.push_back({"cylinder", n, 1, 0, count + 2, 100 * regular_polygon_area(n, 50)});
    all.push_back({"cone", n, 1, 0, count + 1, 100 * regular_polygon_area(n, 50) / 3});
  }
  return all;
}

/// A name that a test may have.
inline std::string test_name(const Expectation& expected) {
  std::string name;
  bool upper = true;
  for (const char c : expected.name) {
    if (c != '-') name += upper && c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c;
    upper = c == '-';
  }
  return expected.size ? name + std::to_string(*expected.size) : name;
}

}  // namespace spoctree::model
