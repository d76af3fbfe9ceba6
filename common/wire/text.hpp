// Texts from outside (names, units, messages) that are safe to print.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace spoctree {

/// True for well-formed UTF-8 of at most `max_bytes` bytes without control characters (U+0000 to
/// U+001F, U+007F to U+009F): it can stand in a terminal, a JSON string and a log line.
bool is_clean_text(std::string_view text, std::size_t max_bytes);

/// `text` made clean: what does not belong becomes '?', what is too long is cut off.
std::string clean_text(std::string_view text, std::size_t max_bytes);

}  // namespace spoctree
