// Words of file formats, which writers have in capitals or not.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace spoctree {

inline char to_lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline char to_upper_case(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

inline std::string to_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = to_lower_case(c);
  return lower;
}

/// Whether the two are equal but for the case of ASCII letters. REQUIRES: the second is in lower
/// case, here and below.
inline bool equals_in_any_case(std::string_view word, std::string_view lower_case) {
  return word.size() == lower_case.size() &&
         std::equal(word.begin(), word.end(), lower_case.begin(),
                    [](char a, char b) { return to_lower_case(a) == b; });
}

inline bool starts_in_any_case(std::string_view text, std::string_view lower_case) {
  return text.size() >= lower_case.size() &&
         equals_in_any_case(text.substr(0, lower_case.size()), lower_case);
}

/// Linear in the text for a short word.
inline bool contains_in_any_case(std::string_view text, std::string_view lower_case) {
  return std::search(text.begin(), text.end(), lower_case.begin(), lower_case.end(),
                     [](char a, char b) { return to_lower_case(a) == b; }) != text.end();
}

}  // namespace spoctree
