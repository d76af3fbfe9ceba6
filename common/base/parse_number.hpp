// One word of text into one number, in full double precision and free of the locale.
#pragma once

#include <cstdint>
#include <string_view>

namespace spoctree {

/// `fault` is null where `value` is good, else it completes the sentence "'1e999' ...".
struct ParsedReal {
  double value = 0;
  const char* fault = nullptr;
};

struct ParsedInteger {
  std::int64_t value = 0;
  const char* fault = nullptr;
};

/// The double nearest to the decimal number that is the whole of `word`; a leading '+' is allowed,
/// and a D for the E of an exponent ("3.0D0", as Fortran writes it).
/// Numbers too small for a double become zero. Words that are not a number, are not finite ("nan",
/// "inf") or exceed the largest double have a fault.
ParsedReal parse_real(std::string_view word);

/// The decimal integer that is the whole of `word`; a leading '+' is allowed.
ParsedInteger parse_integer(std::string_view word);

}  // namespace spoctree
