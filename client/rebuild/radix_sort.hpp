// Sorts records by an integer key in linear time.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace spoctree {

/// Sorts by `key_of(record)`, a 64-bit unsigned integer that is at most `largest`; stable.
/// O(records * bits of `largest`).
template <class Record, class KeyOf>
void radix_sort(std::vector<Record>& records, std::uint64_t largest, KeyOf&& key_of) {
  if (records.size() < 64) {
    std::stable_sort(records.begin(), records.end(),
                     [&](const Record& a, const Record& b) { return key_of(a) < key_of(b); });
    return;
  }
  constexpr int kDigitBits = 11;
  constexpr std::uint64_t kDigits = std::uint64_t{1} << kDigitBits;
  std::vector<Record> sorted(records.size());
  const int bits = std::bit_width(largest);
  for (int shift = 0; shift < bits; shift += kDigitBits) {
    std::array<std::size_t, kDigits> begin{};
    for (const Record& record : records) ++begin[(key_of(record) >> shift) & (kDigits - 1)];
    std::size_t sum = 0;
    for (std::size_t& count : begin) {
      const std::size_t here = count;
      count = sum;
      sum += here;
    }
    for (const Record& record : records) {
      sorted[begin[(key_of(record) >> shift) & (kDigits - 1)]++] = record;
    }
    records.swap(sorted);
  }
}

}  // namespace spoctree
