#include "server/solid/find_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <numeric>
#include <vector>

namespace spoctree {

namespace {

// A model that is nowhere larger than this many units is one of few digits by design.
constexpr double kSmallestModel = 300;

// Numbers nearer to a multiple of the unit than this fraction are one.
constexpr double kNearlyMultiple = 1e-4;

// How far above its mean something is, in standard deviations, and a little more where there are
// few numbers, that is no chance. Coordinates are not independent: eight corners of a box follow
// from four. That is why it is more than the usual three.
constexpr double kDeviations = 5;
constexpr double kMargin = 2;
// The chance of all having a common divisor is then one in so many.
constexpr double kMostLikely = 1e-4;
constexpr double kNumbersThatFollowFromOne = 2;

// Along the axis of a prism coordinates are those of its two ends, and of what is between them.
constexpr std::size_t kMostOfPrism = 3;
// Along an axis along which a model has fewer units than this, nothing can be told.
constexpr double kThinnest = 5;

// One number that ends with more zeros, such as that of a corner which a model was placed by, says
// no more than with these.
constexpr int kMostZeros = 2;
constexpr int kMostZeroBits = 3;

/// Of a number of trials, more than chance has.
bool is_no_chance(double found, double trials, double mean, double variance) {
  return found > trials * mean + kDeviations * std::sqrt(trials * variance) + kMargin;
}

/// Different coordinates along one axis as multiples of the unit, where they are.
struct Multiples {
  std::vector<std::int64_t> whole;  ///< sorted, without 0
  std::size_t others = 0;           ///< with digits beyond the unit
  bool are_few = false;  ///< no more different ones than along the axis of a prism, or all near
};

void keep_different(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

Multiples multiples_along(int axis, double unit, std::span<const glm::dvec3> points) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const glm::dvec3& p : points) values.push_back(p[axis] / unit);
  keep_different(values);
  Multiples found;
  found.are_few = values.size() <= kMostOfPrism || values.back() - values.front() < kThinnest;
  for (double& value : values) value = std::abs(value);
  keep_different(values);
  for (const double value : values) {
    const double whole = std::round(value);
    if (!(std::abs(value - whole) <= kNearlyMultiple) || whole > 0x1p53) {
      ++found.others;
    } else if (whole > 0) {
      found.whole.push_back(static_cast<std::int64_t>(whole));
    }
  }
  return found;
}

/// How round numbers are.
struct Roundness {
  double count = 0;
  double zeros = 0;  ///< at the end, in all together
  double fives = 0;  ///< multiples of 5

  void add(const Roundness& other) {
    count += other.count;
    zeros += other.zeros;
    fives += other.fives;
  }
  bool is_no_chance(int base) const {
    const double chance = 1.0 / base;
    // So many zeros that one more has the chance 1 / base each time.
    const double mean = chance / (1 - chance);
    return spoctree::is_no_chance(zeros, count, mean, mean / (1 - chance)) ||
           (base == 10 && spoctree::is_no_chance(fives, count, 0.2, 0.2 * 0.8));
  }
};

Roundness roundness_of(const Multiples& multiples, int base) {
  Roundness found;
  found.count = static_cast<double>(multiples.whole.size() + multiples.others);
  const int most_zeros = base == 10 ? kMostZeros : kMostZeroBits;
  for (const std::int64_t whole : multiples.whole) {
    found.fives += whole % 5 == 0 ? 1 : 0;
    std::int64_t rest = whole;
    for (int i = 0; i < most_zeros && rest % base == 0; ++i, rest /= base) ++found.zeros;
  }
  return found;
}

bool have_common_divisor(const Multiples& multiples) {
  if (multiples.others > 0) return false;
  std::int64_t divisor = 0;
  for (const std::int64_t whole : multiples.whole) divisor = std::gcd(divisor, whole);
  const auto count = static_cast<double>(multiples.whole.size());
  return std::pow(static_cast<double>(divisor), -count / kNumbersThatFollowFromOne) < kMostLikely;
}

}  // namespace

glm::dvec3 find_rounding(const Precision& precision, std::span<const glm::dvec3> points) {
  glm::dvec3 units = coordinate_spacing(precision, points);
  glm::dvec3 farthest{};
  for (const glm::dvec3& p : points) farthest = glm::max(farthest, glm::abs(p));
  double most_units = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (units[axis] > 0) most_units = std::max(most_units, farthest[axis] / units[axis]);
  }
  if (most_units < kSmallestModel) return {};
  const Precision bits_alone{.binary_digits = precision.binary_digits};
  // What no axis shows by itself, all together may.
  Roundness decimal;
  Roundness binary;
  for (int axis = 0; axis < 3; ++axis) {
    if (units[axis] == 0) continue;
    const int base = bits_alone.spacing_at(farthest[axis]) == units[axis] ? 2 : 10;
    const Multiples multiples = multiples_along(axis, units[axis], points);
    const Roundness roundness = roundness_of(multiples, base);
    if (multiples.are_few || have_common_divisor(multiples) || roundness.is_no_chance(base)) {
      units[axis] = 0;
    } else {
      (base == 2 ? binary : decimal).add(roundness);
    }
  }
  return binary.is_no_chance(2) || decimal.is_no_chance(10) ? glm::dvec3{} : units;
}

}  // namespace spoctree
