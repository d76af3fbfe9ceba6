// Names of models in spo:// sources, and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace spoctree {

/// `text` with every %XX (two hexadecimal digits, RFC 3986) as the byte that it stands for; nothing
/// if a % has no two such digits after it. What comes out may be any bytes.
std::optional<std::string> percent_decoded(std::string_view text);

/// `name` as it can follow spo://HOST:PORT/ in a shell: every byte of ASCII but letters, digits and
/// - . _ ~ as %XX. Characters beyond ASCII stay as they are. percent_decoded is its inverse.
std::string percent_encoded(std::string_view name);

}  // namespace spoctree
