// The small parts of common/wire: varints, texts, the end of an expression.
#include <gtest/gtest.h>

#include "common/wire/expression_meter.hpp"
#include "common/wire/text.hpp"
#include "common/wire/varint.hpp"

namespace spoctree {
namespace {

TEST(Varint, HasTheBytesOfLeb128) {
  const auto bytes_of = [](std::uint32_t value) {
    std::string column;
    append_varint(column, value);
    EXPECT_EQ(column.size(), varint_size(value));
    return column;
  };
  EXPECT_EQ(bytes_of(0), std::string(1, '\0'));
  EXPECT_EQ(bytes_of(127), "\x7f");
  EXPECT_EQ(bytes_of(128), "\x80\x01");
  EXPECT_EQ(bytes_of(624485), "\xe5\x8e\x26");  // the example of the DWARF standard
  EXPECT_EQ(bytes_of(UINT32_MAX), "\xff\xff\xff\xff\x0f");
}

TEST(Varint, IsReadBack) {
  std::string column;
  std::vector<std::uint32_t> values;
  for (std::uint64_t value = 0; value <= UINT32_MAX; value = value * 3 / 2 + 1) {
    values.push_back(static_cast<std::uint32_t>(value));
    append_varint(column, values.back());
  }
  std::string_view rest = column;
  for (const std::uint32_t value : values) EXPECT_EQ(take_varint(rest), value);
  EXPECT_TRUE(rest.empty());
}

TEST(Varint, RefusesWhatIsCutOffTooLargeOrPadded) {
  using namespace std::string_view_literals;
  for (std::string_view bad : {""sv, "\x80"sv, "\xff\xff"sv, "\xff\xff\xff\xff\x1f"sv,
                               "\xff\xff\xff\xff\xff\x01"sv, "\x80\x00"sv, "\x85\x80\x00"sv}) {
    const std::size_t size = bad.size();
    EXPECT_FALSE(take_varint(bad)) << size;
    EXPECT_EQ(bad.size(), size);
  }
}

TEST(Text, KnowsWhatIsSafeToPrint) {
  EXPECT_TRUE(is_clean_text("", 0));
  EXPECT_TRUE(is_clean_text("Stanford bunny (35,947 points).ply", 255));
  EXPECT_TRUE(is_clean_text("Schl\xc3\xbcssel \xe6\xa8\xa1 \xf0\x9f\x90\xb0", 255));
  EXPECT_FALSE(is_clean_text("four", 3));
  for (const char* bad : {"\x1b[2J", "a\nb", "\x7f", "\xc2\x85", "\x80", "\xc0\xaf", "\xe0\x80\xaf",
                          "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xc3", "\xff"}) {
    EXPECT_FALSE(is_clean_text(bad, 255)) << bad;
  }
}

TEST(Text, IsMadeCleanAndCutBetweenCharacters) {
  EXPECT_EQ(clean_text("a\nb\xff\xc3\xbc", 255), "a?b?\xc3\xbc");
  EXPECT_EQ(clean_text("abc\xc3\xbc", 4), "abc");
  EXPECT_TRUE(is_clean_text(clean_text("\xe6\xa8\x1b\xed\xa0\x80\xf0\x9f", 255), 255));
}

TEST(ExpressionMeter, FindsTheEndAndTheDepth) {
  // Split by 0, inside it split by 1 into out and in; outside in.
  const std::uint32_t tokens[] = {2, 3, 0, 1, 1};
  ExpressionMeter meter;
  EXPECT_FALSE(meter.is_done());
  std::size_t deepest = 0;
  for (const std::uint32_t token : tokens) {
    EXPECT_FALSE(meter.is_done());
    meter.take(token);
    deepest = std::max(deepest, meter.depth());
  }
  EXPECT_TRUE(meter.is_done());
  EXPECT_EQ(meter.token_count(), 5u);
  EXPECT_EQ(deepest, 2u);
  meter.restart();
  EXPECT_FALSE(meter.is_done());
  meter.take(kInToken);
  EXPECT_TRUE(meter.is_done());
}

}  // namespace
}  // namespace spoctree
