#include "common/program/output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "common/base/atomic_file.hpp"
#include "common/base/errors.hpp"

namespace spoctree {

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw BadInput(std::string("standard output: cannot write: ") + std::strerror(errno));
}

bool are_one_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  if (a == "-" || b == "-") return a == b;
  const auto status = std::filesystem::status(a, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) return false;
  return a == b || std::filesystem::equivalent(a, b, ignored);
}

void write_output(const std::string& path, std::string_view bytes) {
  if (path == "-") {
    print(bytes);
  } else {
    write_file_atomically(path, bytes);
  }
}

}  // namespace spoctree
