// 256-bit integers against integers of any width.
#include "common/geometry/int256.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "tests/support/random.hpp"

namespace spoctree {
namespace {

using boost::multiprecision::cpp_int;

cpp_int to_any_width(const Int256& value) {
  cpp_int result = 0;
  for (std::size_t i = 4; i-- > 0;) result = (result << 64) | value.limbs()[i];
  // Two's complement: the upper half of the range are the negative numbers.
  return (value.limbs()[3] >> 63) != 0 ? cpp_int(result - (cpp_int(1) << 256)) : result;
}

cpp_int to_any_width(Int128 value) {
  const bool negative = value < 0;
  __extension__ using UInt128 = unsigned __int128;
  const UInt128 magnitude =
      negative ? UInt128{0} - static_cast<UInt128>(value) : static_cast<UInt128>(value);
  const cpp_int result = (cpp_int(static_cast<std::uint64_t>(magnitude >> 64)) << 64) |
                         static_cast<std::uint64_t>(magnitude);
  return negative ? cpp_int(-result) : result;
}

/// Numbers of all lengths up to `bits` <= 126, with long runs of equal bits now and then.
Int128 random_integer(Random& random, int bits) {
  Int128 value = 0;
  switch (random.below(3)) {
    case 0:
      value = (static_cast<Int128>(random.bits() >> 2) << 64) | random.bits();
      value >>= 126 - static_cast<int>(random.below(static_cast<std::uint32_t>(bits) + 1));
      break;
    case 1:
      value = (Int128{1} << random.below(static_cast<std::uint32_t>(bits))) - random.below(2);
      break;
    default:
      value = random.below(3);
  }
  return random.chance(0.5) ? -value : value;
}

TEST(Int256, ComputesAsIntegersOfAnyWidthDo) {
  Random random(1);
  for (int k = 0; k < 20000; ++k) {
    const Int128 a = random_integer(random, 126);
    const Int128 b = random_integer(random, 124);
    const auto c = static_cast<std::int64_t>(random_integer(random, 62));
    const cpp_int wide_a = to_any_width(a);
    const cpp_int wide_b = to_any_width(b);
    ASSERT_EQ(to_any_width(Int256(a)), wide_a);
    ASSERT_EQ(to_any_width(-Int256(a)), -wide_a);
    ASSERT_EQ(to_any_width(Int256(a) * b), wide_a * wide_b);
    ASSERT_EQ(to_any_width(Int256(a) * c), wide_a * c);
    ASSERT_EQ(to_any_width(Int256::product(a, b)), wide_a * wide_b);
    ASSERT_EQ(to_any_width(Int256(a) * b * Int128{2}), 2 * wide_a * wide_b);
    Int256 sum = Int256(a) * b;
    sum += Int256(b) * c;
    const cpp_int expected = wide_a * wide_b + wide_b * c;
    ASSERT_EQ(to_any_width(sum), expected);
    ASSERT_EQ(sum.sign(), expected.sign());
    sum += -sum;
    ASSERT_EQ(sum.sign(), 0);
  }
}

TEST(Int256, ConvertsToLongDoublesWithinItsBound) {
  using Rational = boost::multiprecision::cpp_rational;
  Random random(2);
  for (int k = 0; k < 5000; ++k) {
    const Int256 value = Int256(random_integer(random, 126)) * random_integer(random, 124);
    const cpp_int exact = to_any_width(value);
    const long double rounded = value.to_long_double();
    // A long double as the sum of two doubles.
    const auto high = static_cast<double>(rounded);
    const auto low = static_cast<double>(rounded - static_cast<long double>(high));
    const Rational error = Rational(high) + Rational(low) - Rational(exact);
    EXPECT_LE(abs(error), Rational(abs(exact)) / (cpp_int(1) << 61));
  }
}

}  // namespace
}  // namespace spoctree
