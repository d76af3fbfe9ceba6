// HOST:PORT, as it is written on command lines and in spo:// names.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "common/wire/limits.hpp"

namespace spoctree {

struct Address {
  std::string host;  ///< a name or a number, without brackets
  std::uint16_t port = kDefaultPort;

  bool operator==(const Address&) const = default;
};

/// Reads HOST, HOST:PORT, [HOST] or [HOST]:PORT; the brackets are for numbers with colons (IPv6).
/// Throws UsageError that quotes `text`.
Address parse_address(std::string_view text);

/// HOST:PORT, with brackets where the host has colons.
std::string to_text(const Address& address);

}  // namespace spoctree
