#include "client/commands/parse_level.hpp"

#include "common/base/errors.hpp"
#include "common/base/parse_number.hpp"
#include "common/wire/limits.hpp"

namespace spoctree {

std::uint32_t parse_level(const std::string& text) {
  const ParsedInteger level = parse_integer(text);
  if (level.fault != nullptr || level.value < 0 || level.value >= kMaxLevels)
    throw UsageError("--level: '" + text + "' should be a number from 0 to " +
                     std::to_string(kMaxLevels - 1));
  return static_cast<std::uint32_t>(level.value);
}

}  // namespace spoctree
