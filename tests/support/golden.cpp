#include "tests/support/golden.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "common/base/atomic_file.hpp"

namespace spoctree {

namespace {

const std::filesystem::path kRepository = SPOCTREE_SOURCE_DIR;

bool is_update() { return std::getenv("SPOCTREE_UPDATE_GOLDENS") != nullptr; }

std::string read_bytes(const std::filesystem::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

}  // namespace

void expect_golden(const std::string& name, const std::string& bytes) {
  const auto path = kRepository / "tests" / "golden" / name;
  if (is_update()) write_file_atomically(path, bytes);
  EXPECT_EQ(read_bytes(path), bytes) << name << " differs; if it should, run tools/update-goldens";
}

void expect_shown(const std::filesystem::path& path, const std::string& name,
                  const std::string& text) {
  std::string file = read_bytes(kRepository / path);
  const std::string begin_line = "<!-- " + name + " begins -->\n";
  const std::size_t line = file.find(begin_line);
  ASSERT_NE(line, std::string::npos) << path;
  const std::size_t begin = line + begin_line.size();
  const std::size_t end = file.find("<!-- " + name + " ends -->\n", begin);
  ASSERT_NE(end, std::string::npos) << path;
  if (is_update()) {
    write_file_atomically(kRepository / path, file.replace(begin, end - begin, text));
    return;
  }
  EXPECT_EQ(file.substr(begin, end - begin), text)
      << path << " is out of date; run tools/update-goldens";
}

}  // namespace spoctree
