// The value of `--level` -> a level.
#pragma once

#include <cstdint>
#include <string>

namespace spoctree {

/// Throws UsageError: "--level: 'x' should be a number from 0 to 30".
std::uint32_t parse_level(const std::string& text);

}  // namespace spoctree
