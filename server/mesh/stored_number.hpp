// Bytes of a binary file into one number, whatever the byte order of this machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace spoctree {

enum class ByteOrder { LittleEndian, BigEndian };

/// The number of type T (integer, float or double) stored at `offset`.
/// REQUIRES offset + sizeof(T) <= bytes.size().
template <class T>
T stored_number(std::string_view bytes, std::size_t offset, ByteOrder order) {
  static_assert(std::is_arithmetic_v<T> && sizeof(T) <= 8);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const std::size_t place = order == ByteOrder::LittleEndian ? i : sizeof(T) - 1 - i;
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[offset + i])} << (8 * place);
  }
  if constexpr (std::is_same_v<T, double>) {
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  } else if constexpr (std::is_same_v<T, float>) {
    const auto low = static_cast<std::uint32_t>(bits);
    float value;
    std::memcpy(&value, &low, sizeof value);
    return value;
  } else {
    return static_cast<T>(bits);
  }
}

}  // namespace spoctree
