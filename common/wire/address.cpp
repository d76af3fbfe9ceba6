#include "common/wire/address.hpp"

#include <charconv>

#include "common/base/errors.hpp"
#include "common/wire/text.hpp"

namespace spoctree {

namespace {
constexpr std::size_t kMaxHostBytes = 253;  // of a domain name
}

Address parse_address(std::string_view text) {
  const auto fail = [&](const std::string& what) {
    throw UsageError("'" + clean_text(text, kMaxNameBytes) + "' is no HOST:PORT: " + what);
  };
  Address address;
  std::string_view rest;
  if (text.starts_with('[')) {
    const auto end = text.find(']');
    if (end == std::string_view::npos) fail("']' is missing");
    address.host = text.substr(1, end - 1);
    rest = text.substr(end + 1);
  } else {
    const auto colon = text.find(':');
    if (colon != text.rfind(':')) fail("an IPv6 host stands in brackets, as in [::1]:7762");
    address.host = text.substr(0, colon);
    rest = text.substr(address.host.size());
  }
  if (address.host.empty()) fail("the host is missing");
  if (!is_clean_text(address.host, kMaxHostBytes)) fail("not a host");
  if (rest.empty()) return address;
  if (!rest.starts_with(':')) fail("':' and a port should follow the host");
  rest.remove_prefix(1);
  const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), address.port);
  if (error != std::errc() || stop != rest.data() + rest.size())
    fail("the port should be a number from 0 to 65535");
  return address;
}

std::string to_text(const Address& address) {
  const bool has_colons = address.host.find(':') != std::string::npos;
  return (has_colons ? "[" + address.host + "]" : address.host) + ":" +
         std::to_string(address.port);
}

}  // namespace spoctree
