#include "common/program/output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "common/base/atomic_file.hpp"
#include "common/base/errors.hpp"

namespace spoctree {

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw BadInput(std::string("standard output: cannot write: ") + std::strerror(errno));
}

void write_output(const std::string& path, std::string_view bytes) {
  if (path == "-") {
    print(bytes);
  } else {
    write_file_atomically(path, bytes);
  }
}

}  // namespace spoctree
