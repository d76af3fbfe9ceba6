#include "server/mesh/precision.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace spoctree {

namespace {

constexpr int kSingleBits = 24;
constexpr int kSinglesDigits = 7;  // which any number of so many has

// Fewer significant digits are what a designer writes, not what rounding leaves.
constexpr int kFewestDigitsAsLimit = 4;
// Longer words have more digits than any double.
constexpr int kLongestWord = 400;
// The chance that numbers show a limit that is none is 10^-2, and 2^-20.
constexpr std::uint64_t kDigitsOfEvidence = 2;
constexpr int kBitsOfEvidence = 20;

// One number that lacks more digits, such as that of a corner which a model was placed by, says no
// more than with these.
constexpr int kMostMissingDigits = 2;

double power_of_ten(int exponent) { return std::pow(10.0, exponent); }

int decade_of(double magnitude) {
  const int decade = static_cast<int>(std::floor(std::log10(magnitude)));
  // Logarithms of numbers just below a power of ten may be rounded up to it.
  return magnitude < power_of_ten(decade) ? decade - 1 : decade;
}

double spacing_of_bits(double magnitude, int bits) {
  int exponent = 0;
  std::frexp(magnitude, &exponent);
  return std::ldexp(1.0, exponent - bits);
}

/// A number's digits, places counted in powers of ten.
struct WrittenDigits {
  bool is_zero = true;
  int first_place = 0;     ///< of the first digit that is not zero
  int last_place = 0;      ///< of the last digit
  int digits = 0;          ///< from the first to the last one that is not zero
  int written_digits = 0;  ///< the same, with zeros at the end that stand behind the point
  bool has_exponent = false;
};

WrittenDigits read_digits(std::string_view word) {
  WrittenDigits found;
  int decimals = 0;  // digits behind the point
  int since_first = 0;
  bool is_behind_point = false;
  std::size_t i = 0;
  for (; i < word.size(); ++i) {
    const char c = word[i];
    if (c >= '0' && c <= '9') {
      decimals += is_behind_point ? 1 : 0;
      if (c != '0' && found.is_zero) {
        found.is_zero = false;
        found.first_place = -decimals;
      }
      if (found.is_zero) continue;
      ++since_first;
      if (!is_behind_point) found.first_place = since_first - 1;
      if (c != '0') found.digits = since_first;
    } else if (c == '.') {
      is_behind_point = true;
    } else if (c == 'e' || c == 'E' || c == 'd' || c == 'D') {
      break;
    }
  }
  found.last_place = -decimals;
  found.written_digits = is_behind_point ? since_first : found.digits;
  if (i == word.size()) return found;
  found.has_exponent = true;
  int exponent = 0;
  bool is_negative = false;
  for (++i; i < word.size(); ++i) {
    if (word[i] == '-') is_negative = true;
    if (word[i] >= '0' && word[i] <= '9') exponent = std::min(999, 10 * exponent + word[i] - '0');
  }
  if (is_negative) exponent = -exponent;
  found.first_place += exponent;
  found.last_place += exponent;
  return found;
}

}  // namespace

double Precision::spacing_at(double coordinate) const {
  const double magnitude = std::abs(coordinate);
  if (magnitude == 0) return unit;
  double spacing = std::max(unit, spacing_of_bits(magnitude, binary_digits));
  if (decimal_digits > 0) {
    spacing = std::max(spacing, power_of_ten(decade_of(magnitude) - decimal_digits + 1));
  }
  return spacing;
}

glm::dvec3 coordinate_spacing(const Precision& precision, std::span<const glm::dvec3> points) {
  if (points.empty()) return {};
  glm::dvec3 farthest{};
  for (const glm::dvec3& p : points) farthest = glm::max(farthest, glm::abs(p));
  return {precision.spacing_at(farthest.x), precision.spacing_at(farthest.y),
          precision.spacing_at(farthest.z)};
}

void DigitRecord::compare_with_single(double value, int last_place) {
  if (value == 0) return;  // too small for a double
  const double single = static_cast<double>(static_cast<float>(value));
  const double unit = power_of_ten(last_place);
  // Not exactly a half: the value itself is rounded.
  if (!(std::abs(value - single) <= 0.5000001 * unit)) {
    is_single_ = false;
    return;
  }
  const double spacing = spacing_of_bits(std::abs(value), kSingleBits);
  if (spacing > unit && evidence_for_single_ < kBitsOfEvidence) {
    evidence_for_single_ += std::min(kBitsOfEvidence, std::ilogb(spacing / unit));
  }
}

void DigitRecord::add(int axis, std::string_view word, double value) {
  if (word.size() > std::size_t{kLongestWord}) {
    ++numbers_;
    lowest_place_ = -kLongestWord;
    most_digits_ = kLongestWord;
    return;
  }
  const WrittenDigits written = read_digits(word);
  if (!written.has_exponent || !written.is_zero) {
    lowest_place_ = std::min(lowest_place_, written.last_place);
    highest_place_ = std::max(highest_place_, written.last_place);
  }
  if (written.is_zero) return;
  ++numbers_;
  with_exponent_ += written.has_exponent ? 1 : 0;
  most_digits_ = std::max(most_digits_, written.written_digits);
  fewest_digits_ = std::min(fewest_digits_, written.written_digits);
  const int decade = std::clamp(written.first_place - kLowestDecade, 0, kDecades - 1);
  ++counts_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(decade)]
           [static_cast<std::size_t>(std::min(written.digits, kMostDigits))];
  if (is_single_ && written.digits > kSinglesDigits) {
    compare_with_single(value, written.first_place - written.digits + 1);
  }
}

// For each axis, digits that are missing at the end: one zero costs a factor of ten of likelihood
// if numbers were rounded there.
bool DigitRecord::has_digits_as_limit(int digits, int last_place) const {
  if (digits < kFewestDigitsAsLimit || digits >= kMostDigits) return false;
  std::uint64_t evidence = 0;
  for (const Counts& counts : counts_) {
    std::uint64_t numbers = 0;
    std::uint64_t missing = 0;           // of `digits`
    std::uint64_t missing_to_place = 0;  // down to `last_place`
    for (int decade = 0; decade < kDecades; ++decade) {
      for (int used = 1; used <= digits; ++used) {
        const std::uint64_t count =
            counts[static_cast<std::size_t>(decade)][static_cast<std::size_t>(used)];
        if (count == 0) continue;
        const auto zeros = [count](int places) {
          return count * static_cast<std::uint64_t>(std::clamp(places, 0, kMostMissingDigits));
        };
        numbers += count;
        missing += zeros(digits - used);
        missing_to_place += zeros(decade + kLowestDecade - used + 1 - last_place);
      }
    }
    const bool is_in_full = 2 * missing <= numbers;
    if (is_in_full && missing_to_place > missing) evidence += missing_to_place - missing;
  }
  return evidence >= kDigitsOfEvidence;
}

Precision DigitRecord::precision() const {
  Precision found;
  if (numbers_ == 0) return found;
  if (is_single_ && evidence_for_single_ >= kBitsOfEvidence) found.binary_digits = kSingleBits;
  const bool is_place_fixed = with_exponent_ == 0 && lowest_place_ == highest_place_;
  const bool is_scientific = with_exponent_ == numbers_ && most_digits_ == fewest_digits_;
  if (!is_place_fixed && (is_scientific || has_digits_as_limit(most_digits_, lowest_place_))) {
    found.decimal_digits = most_digits_;
  } else {
    found.unit = power_of_ten(lowest_place_);
  }
  return found;
}

void BitRecord::add_double(double value) {
  if (static_cast<double>(static_cast<float>(value)) != value) has_doubles_ = true;
  // Two bits fewer: the last ones may be zero.
  int exponent = 0;
  const double scaled = std::ldexp(std::frexp(value, &exponent), kSingleBits - 3);
  if (scaled == std::trunc(scaled)) {
    has_short_doubles_ = true;
  } else {
    has_bits_of_single_ = true;
  }
}

Precision BitRecord::precision() const {
  Precision found;
  if (has_doubles_ || (has_short_doubles_ && !has_bits_of_single_)) return found;
  if (has_singles_ || has_bits_of_single_) {
    found.binary_digits = kSingleBits;
  } else if (has_wholes_) {
    found.unit = 1;
  }
  return found;
}

}  // namespace spoctree
