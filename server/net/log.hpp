// What the server tells its operator: lines with a time on standard error.
#pragma once

#include <string>

namespace spoctree {

/// Text that came from a client must be clean (common/wire/text.hpp).
void log_info(const std::string& text);
void log_warning(const std::string& text);

}  // namespace spoctree
