// Two doubles at a time, and the answers to questions about them as two bits.
#pragma once

#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace spoctree {

#if defined(__SSE2__)

/// What every processor that has pairs of doubles does in one instruction each.
class DoublePair {
 public:
  explicit DoublePair(double both) : pair_(_mm_set1_pd(both)) {}
  static DoublePair load(const double* first) { return DoublePair(_mm_loadu_pd(first)); }
  void store(double* first) const { _mm_storeu_pd(first, pair_); }

  DoublePair operator+(DoublePair other) const { return DoublePair(pair_ + other.pair_); }
  DoublePair operator-(DoublePair other) const { return DoublePair(pair_ - other.pair_); }
  DoublePair operator*(DoublePair other) const { return DoublePair(pair_ * other.pair_); }
  DoublePair magnitude() const { return DoublePair(_mm_andnot_pd(_mm_set1_pd(-0.0), pair_)); }
  /// Bit 0 if the first number is larger than the other's, bit 1 for the second one.
  std::uint32_t is_larger_than(DoublePair other) const {
    return static_cast<std::uint32_t>(_mm_movemask_pd(_mm_cmpgt_pd(pair_, other.pair_)));
  }

 private:
  explicit DoublePair(__m128d pair) : pair_(pair) {}
  __m128d pair_;
};

#else

class DoublePair {
 public:
  explicit DoublePair(double both) : DoublePair(both, both) {}
  static DoublePair load(const double* first) { return {first[0], first[1]}; }
  void store(double* first) const {
    first[0] = first_;
    first[1] = second_;
  }

  DoublePair operator+(DoublePair o) const { return {first_ + o.first_, second_ + o.second_}; }
  DoublePair operator-(DoublePair o) const { return {first_ - o.first_, second_ - o.second_}; }
  DoublePair operator*(DoublePair o) const { return {first_ * o.first_, second_ * o.second_}; }
  DoublePair magnitude() const { return {std::abs(first_), std::abs(second_)}; }
  /// Bit 0 if the first number is larger than the other's, bit 1 for the second one.
  std::uint32_t is_larger_than(DoublePair other) const {
    return (first_ > other.first_ ? 1u : 0u) | (second_ > other.second_ ? 2u : 0u);
  }

 private:
  DoublePair(double first, double second) : first_(first), second_(second) {}
  double first_, second_;
};

#endif

}  // namespace spoctree
