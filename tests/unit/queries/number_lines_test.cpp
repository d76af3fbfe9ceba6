#include "client/queries/number_lines.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "common/base/errors.hpp"

namespace spoctree {
namespace {

struct Read {
  std::vector<std::uint64_t> lines;
  std::vector<std::vector<double>> numbers;
  std::string error;
};

/// Feeds `text` in pieces of `piece` bytes.
Read read(const std::string& text, std::size_t per_line, std::size_t piece) {
  Read result;
  NumberLines lines("it", per_line, [&](std::uint64_t line, std::span<const double> numbers) {
    result.lines.push_back(line);
    result.numbers.emplace_back(numbers.begin(), numbers.end());
  });
  try {
    for (std::size_t i = 0; i < text.size(); i += piece) lines.feed(text.substr(i, piece));
    lines.finish();
  } catch (const BadInput& error) {
    result.error = error.what();
  }
  return result;
}

TEST(NumberLines, AreTheSameInPiecesOfAnySize) {
  const std::string text = "# points\n1 2 3\n\n  \t-4e2\t.5 +6  \r\n#7 8 9\n1e-400 0 1";
  for (std::size_t piece = 1; piece <= text.size(); ++piece) {
    const Read result = read(text, 3, piece);
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.lines, (std::vector<std::uint64_t>{2, 4, 6}));
    EXPECT_EQ(result.numbers,
              (std::vector<std::vector<double>>{{1, 2, 3}, {-400, 0.5, 6}, {0, 0, 1}}));
  }
}

TEST(NumberLines, NameTheLineThatIsWrongAfterThoseThatAreRight) {
  const std::pair<const char*, const char*> cases[] = {
      {"1 2", "it: line 3: 2 numbers where 3 belong"},
      {"1", "it: line 3: 1 number where 3 belong"},
      {"1 2 3 4 5 6 7 8 9", "it: line 3: 9 numbers where 3 belong"},
      {"1 2 x", "it: line 3: 'x' is not a number"},
      {"1 2 3x", "it: line 3: '3x' is not a number"},
      {"1,2,3", "it: line 3: '1,2,3' is not a number"},
      {"1 2 nan", "it: line 3: 'nan' is not a finite number"},
      {"1 -inf 2", "it: line 3: '-inf' is not a finite number"},
      {"1 1e999 2", "it: line 3: '1e999' is too large a number"},
      {"1 0x10 2", "it: line 3: '0x10' is not a number"},
      {"\x01\xff 1 2", "it: line 3: '?\?' is not a number"},
      {" # 1 2", "it: line 3: '#' is not a number"},
  };
  for (const auto& [line, error] : cases) {
    for (const char* end : {"", "\n", "\n1 2 3\n"}) {
      const Read result = read("0 0 0\n\n" + std::string(line) + end, 3, 7);
      EXPECT_EQ(result.error, error);
      EXPECT_EQ(result.lines, std::vector<std::uint64_t>{1});
    }
  }
}

TEST(NumberLines, RefuseLinesWithoutAnEnd) {
  const Read result = read("1 2 3\n" + std::string(10'000'000, ' '), 3, 65'536);
  EXPECT_EQ(result.error, "it: line 2: longer than 4096 bytes");
  EXPECT_EQ(read(std::string(4090, ' ') + "1 2 3\n", 3, 100).error, "");
}

TEST(NumberLines, BearAnyByteAnywhere) {
  const std::string text = "1 2 3\n4 5 6\n";
  for (std::size_t at = 0; at < text.size(); ++at) {
    for (int byte = 0; byte < 256; ++byte) {
      std::string changed = text;
      changed[at] = static_cast<char>(byte);
      read(changed, 3, 5);
    }
  }
}

}  // namespace
}  // namespace spoctree
