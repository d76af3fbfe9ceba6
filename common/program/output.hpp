// Where results go: a file that is whole or absent, or standard output.
#pragma once

#include <string>
#include <string_view>

namespace spoctree {

/// Writes to standard output and flushes. Throws BadInput when that cannot be done.
void print(std::string_view text);

/// Writes `bytes` to `path` (write_file_atomically), or to standard output where `path` is "-".
void write_output(const std::string& path, std::string_view bytes);

}  // namespace spoctree
