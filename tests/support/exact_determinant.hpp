// Determinants of three differences of points: doubles where they are certain, rational numbers
// where they are not.
#pragma once

#include "common/geometry/universe.hpp"

namespace spoctree {

/// to - from, without the rounding.
struct ExactDifference {
  Vec3 to{0.0};
  Vec3 from{0.0};
};

/// A determinant of three differences; its sign is always right, and 0 is 0.
class ExactDeterminant {
 public:
  ExactDeterminant(const ExactDifference& a, const ExactDifference& b, const ExactDifference& c);

  int sign() const { return value_ > 0 ? 1 : value_ < 0 ? -1 : 0; }

  /// Where a linear function that is `at_0` at 0 and `at_1` at 1 is zero, to 1e-9 or better.
  /// REQUIRES: opposite signs.
  static double root(const ExactDeterminant& at_0, const ExactDeterminant& at_1);

 private:
  ExactDifference a_, b_, c_;
  double value_ = 0;
  double error_ = 0;
};

}  // namespace spoctree
