// How finely a mesh file writes its coordinates: what its numbers cannot tell apart.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

namespace spoctree {

/// The numbers that a file can hold. Each limit is there whether or not the others are; the default
/// is that of doubles.
struct Precision {
  int decimal_digits = 0;  ///< significant decimal digits of each number at most; 0: no such limit
  double unit = 0;         ///< all numbers are multiples of it, a power of ten; 0: no such limit
  int binary_digits = 53;  ///< significant bits of each number: 24 for single precision

  /// The distance of neighbouring numbers of the file at `coordinate` (in the file's units): the
  /// largest that the limits make it. A number was rounded by at most half of it. Of 0: that of the
  /// unit alone.
  double spacing_at(double coordinate) const;
};

/// The spacing along each axis where the points are farthest from 0: the most that a coordinate may
/// differ from another that was the same before both were written. Zero without points. Linear.
glm::dvec3 coordinate_spacing(const Precision& precision, std::span<const glm::dvec3> points);

/// Collects how the coordinates of a text file are written, to tell from all of them together how
/// its writer rounded: zeros at the end of a number are often left out, so that "100" may stand for
/// 100.000, and a single number says little.
class DigitRecord {
 public:
  /// A coordinate along `axis` (0 to 2), as it stands in the file, and its value. What is no
  /// digit, point or exponent is passed over. A few nanoseconds.
  void add(int axis, std::string_view word, double value);

  /// As many digits before and behind the point as some number has (a fixed unit), unless
  /// - on some axis, most numbers have exactly as many significant digits as the longest has (four
  ///   or more), in more than one decade of magnitude: significant digits are the limit;
  /// - or all numbers have as many significant digits, in the form with an exponent.
  /// Where doubt is left, the finer one. Bits are those of single precision if numbers with more
  /// digits than that are all the nearest to one of its numbers, too often for chance.
  Precision precision() const;

 private:
  // Magnitudes are counted by the decade of the first digit, the last ones together with all beyond
  // them; digits up to the last one that is not zero.
  static constexpr int kLowestDecade = -24;
  static constexpr int kDecades = 48;
  static constexpr int kMostDigits = 18;
  using Counts = std::array<std::array<std::uint32_t, kMostDigits + 1>, kDecades>;

  bool has_digits_as_limit(int digits, int last_place) const;
  void compare_with_single(double value, int last_place);

  std::array<Counts, 3> counts_{};  // for each axis, by decade and digits
  std::uint64_t numbers_ = 0;       // that are not zero
  std::uint64_t with_exponent_ = 0;
  int lowest_place_ = 1000;      // of the last digits that are written: 10^-3 is -3
  int highest_place_ = -1000;    // of the same, zeros at the end included
  int most_digits_ = 0;          // significant ones that are written
  int fewest_digits_ = 1000;     // zeros at the end included
  bool is_single_ = true;        // as far as numbers could have shown that it is not
  int evidence_for_single_ = 0;  // bits
};

/// The same for the numbers of a binary file.
class BitRecord {
 public:
  void add_whole() { has_wholes_ = true; }
  void add_single() { has_singles_ = true; }
  void add_double(double value);

  /// Whole numbers have the unit 1. Doubles have single precision if no number has more bits, and
  /// one has as many. Of several kinds, the finest.
  Precision precision() const;

 private:
  bool has_wholes_ = false;
  bool has_singles_ = false;
  bool has_doubles_ = false;         // with more bits than singles have
  bool has_short_doubles_ = false;   // with fewer
  bool has_bits_of_single_ = false;  // with as many, or more
};

}  // namespace spoctree
