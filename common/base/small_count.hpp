// Sizes -> 32-bit numbers, or an error that names what there is too much of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "common/base/errors.hpp"

namespace spoctree {

/// What 32 bits can count.
inline constexpr std::size_t kMostIn32Bits = std::numeric_limits<std::uint32_t>::max();

[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_count(const char* what,
                                                                std::size_t most) {
  throw BadInput("more than " + std::to_string(most) + " " + what);
}

/// `size` itself. Throws BadInput, "more than MOST WHAT", if there are more. REQUIRES: most <=
/// kMostIn32Bits.
inline std::uint32_t small_count(std::size_t size, const char* what,
                                 std::size_t most = kMostIn32Bits) {
  if (size > most) refuse_count(what, most);
  return static_cast<std::uint32_t>(size);
}

}  // namespace spoctree
