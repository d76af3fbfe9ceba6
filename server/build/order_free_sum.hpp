// Doubles -> their sum, the same in whatever order they come.
#pragma once

#include "common/geometry/int256.hpp"

namespace spoctree {

/// A sum in fixed point. Adding integers is associative, so threads may add up parts as they like.
/// Every value is rounded to a multiple of 2^-100. REQUIRES: the sum stays below 2^26 in magnitude.
class OrderFreeSum {
 public:
  void add(double value) { units_ += static_cast<Int128>(value * kUnitsPerOne); }
  void add(const OrderFreeSum& other) { units_ += other.units_; }
  /// The sum so far, rounded once.
  double value() const { return static_cast<double>(units_) / kUnitsPerOne; }

 private:
  static constexpr double kUnitsPerOne = 0x1p100;
  Int128 units_ = 0;
};

}  // namespace spoctree
