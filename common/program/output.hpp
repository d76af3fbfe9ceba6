// Where results go: a file that is whole or absent, or standard output.
#pragma once

#include <string>
#include <string_view>

namespace spoctree {

/// Writes to standard output and flushes. Throws BadInput when that cannot be done.
void print(std::string_view text);

/// Whether writing to one of these paths would change the other one. What is written to a device is
/// not lost in it by writing more.
bool are_one_file(const std::string& a, const std::string& b);

/// Writes `bytes` to `path` (write_file_atomically), or to standard output where `path` is "-".
void write_output(const std::string& path, std::string_view bytes);

}  // namespace spoctree
