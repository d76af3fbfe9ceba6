#include "common/base/parse_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace spoctree {

namespace {

// std::from_chars knows no leading plus sign; many writers of mesh files do.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

// std::from_chars reports numbers below and above the range of double alike. Which of the two a
// valid number is follows from the sign of the decimal exponent of its first nonzero digit.
bool is_below_range(std::string_view word) {
  const std::size_t e = word.find_first_of("eE");
  const std::string_view digits = word.substr(0, e);
  const std::size_t first = digits.find_first_of("123456789");
  if (first == std::string_view::npos) return true;
  std::int64_t exponent = 0;
  if (e != std::string_view::npos) {
    const std::string_view text = without_plus(word.substr(e + 1));
    const auto end = text.data() + text.size();
    if (std::from_chars(text.data(), end, exponent).ec != std::errc()) {
      return text.front() == '-';  // an exponent of more than 18 digits
    }
  }
  const std::size_t point = digits.find('.');
  const std::size_t units = point == std::string_view::npos ? digits.size() : point;
  return exponent < static_cast<std::int64_t>(first) - static_cast<std::int64_t>(units);
}

// Why a word that std::from_chars does not take is no number: what else it may be.
const char* fault_of(std::string_view word) {
  if (std::count(word.begin(), word.end(), ',') == 1) {
    std::string with_point(word);
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    if (parse_real(with_point).fault == nullptr)
      return "is not a number (a comma where a point should be)";
  }
  return "is not a number";
}

}  // namespace

ParsedReal parse_real(std::string_view word) {
  word = without_plus(word);
  ParsedReal parsed;
  const auto end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, parsed.value);
  if (error == std::errc::invalid_argument || stop != end) {
    // Fortran writes the exponents of its double precision with a D.
    if (const std::size_t d = word.find_first_of("dD");
        d != std::string_view::npos && word.find_first_of("eE") == std::string_view::npos) {
      std::string with_e(word);
      with_e[d] = 'e';
      return parse_real(with_e);
    }
    parsed.fault = fault_of(word);
  } else if (error == std::errc::result_out_of_range) {
    if (!is_below_range(word)) parsed.fault = "is too large a number";
    parsed.value = 0;
  } else if (!std::isfinite(parsed.value)) {
    parsed.fault = "is not a finite number";
  }
  return parsed;
}

ParsedInteger parse_integer(std::string_view word) {
  word = without_plus(word);
  ParsedInteger parsed;
  const auto end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, parsed.value);
  if (error == std::errc::invalid_argument || stop != end) {
    parsed.fault = "is not a whole number";
  } else if (error == std::errc::result_out_of_range) {
    parsed.fault = "is too large a number";
  }
  return parsed;
}

}  // namespace spoctree
