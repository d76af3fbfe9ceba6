// Values to JSON, and numbers to their shortest text.
#pragma once

#include <string>
#include <string_view>

namespace spoctree {

/// The shortest decimal that reads back as `value`. Not finite: "null", which JSON has for it.
std::string to_text(double value);

/// Six significant digits: for people, who compare and do not compute with them.
std::string to_short_text(double value);

/// `text` in quotes, with what JSON does not allow in a string escaped.
std::string quote_json(std::string_view text);

}  // namespace spoctree
