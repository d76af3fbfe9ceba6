// Signed 256-bit integers with just what the determinants of planes need. Boost's fixed-width
// integers do the same some ten times slower, and the signs of these determinants are the inner
// loop of building, rebuilding and drawing.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace spoctree {

__extension__ using Int128 = __int128;

// The error bounds of what is first tried in long doubles, here and in predicates.cpp.
static_assert(std::numeric_limits<long double>::digits >= 64);

/// Two's complement, limbs from the lowest. Results that do not fit are taken modulo 2^256: callers
/// know their widths.
class Int256 {
 public:
  Int256() = default;
  Int256(Int128 value)  // NOLINT(google-explicit-constructor): a widening
      : limbs_{static_cast<std::uint64_t>(value), static_cast<std::uint64_t>(value >> 64),
               extension(value), extension(value)} {}

  Int256& operator+=(const Int256& other) {
    UInt128 carry = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      carry += static_cast<UInt128>(limbs_[i]) + other.limbs_[i];
      limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return *this;
  }
  Int256 operator-() const {
    Int256 result;
    UInt128 carry = 1;
    for (std::size_t i = 0; i < 4; ++i) {
      carry += static_cast<std::uint64_t>(~limbs_[i]);
      result.limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return result;
  }
  Int256 operator*(std::int64_t factor) const {
    const Int256 product = times(magnitude(factor), 0);
    return factor < 0 ? -product : product;
  }
  Int256 operator*(Int128 factor) const {
    const bool negative = factor < 0;
    const auto magnitude = static_cast<UInt128>(negative ? -factor : factor);
    Int256 product = times(static_cast<std::uint64_t>(magnitude), 0);
    product += times(static_cast<std::uint64_t>(magnitude >> 64), 1);
    return negative ? -product : product;
  }

  /// The product of two numbers.
  static Int256 product(Int128 a, Int128 b) {
    const auto u = static_cast<UInt128>(a < 0 ? -a : a);
    const auto v = static_cast<UInt128>(b < 0 ? -b : b);
    const auto low = [](UInt128 x) { return static_cast<UInt128>(static_cast<std::uint64_t>(x)); };
    const UInt128 bottom = low(u) * low(v);
    const UInt128 left = (u >> 64) * low(v);
    const UInt128 right = low(u) * (v >> 64);
    const UInt128 middle = (bottom >> 64) + low(left) + low(right);
    const UInt128 top = (u >> 64) * (v >> 64) + (left >> 64) + (right >> 64) + (middle >> 64);
    Int256 result;
    result.limbs_ = {static_cast<std::uint64_t>(bottom), static_cast<std::uint64_t>(middle),
                     static_cast<std::uint64_t>(top), static_cast<std::uint64_t>(top >> 64)};
    return (a < 0) != (b < 0) ? -result : result;
  }

  int sign() const {
    if ((limbs_[3] >> 63) != 0) return -1;
    return (limbs_[0] | limbs_[1] | limbs_[2] | limbs_[3]) != 0 ? 1 : 0;
  }
  /// Relative error below 2^-61.
  long double to_long_double() const {
    const bool negative = sign() < 0;
    const Int256 magnitude = negative ? -*this : *this;
    long double value = 0;
    for (std::size_t i = 4; i-- > 0;) {
      value = value * 0x1p64L + static_cast<long double>(magnitude.limbs_[i]);
    }
    return negative ? -value : value;
  }
  const std::array<std::uint64_t, 4>& limbs() const { return limbs_; }

 private:
  __extension__ using UInt128 = unsigned __int128;

  static std::uint64_t extension(Int128 value) { return value < 0 ? ~std::uint64_t{0} : 0; }
  static std::uint64_t magnitude(std::int64_t value) {
    return value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
  }
  /// This times `factor` times 2^(64 shift).
  Int256 times(std::uint64_t factor, std::size_t shift) const {
    Int256 result;
    UInt128 carry = 0;
    for (std::size_t i = 0; i + shift < 4; ++i) {
      carry += static_cast<UInt128>(limbs_[i]) * factor;
      result.limbs_[i + shift] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return result;
  }

  std::array<std::uint64_t, 4> limbs_{0, 0, 0, 0};
};

}  // namespace spoctree
