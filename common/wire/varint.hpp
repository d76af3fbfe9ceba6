// Unsigned 32-bit numbers to 1 .. 5 bytes (LEB128) and back.
//
// Seven bits a byte, lowest first; the top bit says that another byte follows. The shortest form
// is the only one accepted, so that a column has one spelling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace spoctree {

inline std::size_t varint_size(std::uint32_t value) {
  std::size_t size = 1;
  for (; value >= 128; value >>= 7) ++size;
  return size;
}

inline void append_varint(std::string& column, std::uint32_t value) {
  for (; value >= 128; value >>= 7) column.push_back(static_cast<char>(value | 128));
  column.push_back(static_cast<char>(value));
}

/// Takes a number off the front of `column`; nothing if it is cut off, too large, or not in its
/// shortest form.
inline std::optional<std::uint32_t> take_varint(std::string_view& column) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 5 && i < column.size(); ++i) {
    const auto byte = static_cast<unsigned char>(column[i]);
    value |= std::uint64_t{byte & 127u} << (7 * i);
    if (byte >= 128) continue;
    if ((byte == 0 && i > 0) || value > UINT32_MAX) return std::nullopt;
    column.remove_prefix(i + 1);
    return static_cast<std::uint32_t>(value);
  }
  return std::nullopt;
}

}  // namespace spoctree
