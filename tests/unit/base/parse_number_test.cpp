#include "common/base/parse_number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace spoctree {
namespace {

TEST(ParseReal, ReadsEveryDigitOfADouble) {
  EXPECT_EQ(parse_real("0.1").value, 0.1);
  EXPECT_EQ(parse_real("0.1000000000000000055511151231257827").value, 0.1);
  EXPECT_EQ(parse_real("-1.7976931348623157e308").value, -1.7976931348623157e308);
  EXPECT_EQ(parse_real("9007199254740993").value, 9007199254740992.0);  // ties to even
  EXPECT_EQ(parse_real("-1.54743e-018").value, -1.54743e-18);
}

TEST(ParseReal, AcceptsALeadingPlusAndBareDots) {
  EXPECT_EQ(parse_real("+2.5").value, 2.5);
  EXPECT_EQ(parse_real("+2.5").fault, nullptr);
  EXPECT_EQ(parse_real(".5").value, 0.5);
  EXPECT_EQ(parse_real("5.").value, 5.0);
}

TEST(ParseReal, ReadsExponentsOfFortran) {
  for (const char* word : {"3.0D0", "3d0", "0.3D+1", "300.d-02", "+3.0D0"}) {
    EXPECT_EQ(parse_real(word).fault, nullptr) << word;
    EXPECT_EQ(parse_real(word).value, 3.0) << word;
  }
  EXPECT_EQ(parse_real("1D-400").value, 0.0);
  EXPECT_STREQ(parse_real("1D999").fault, "is too large a number");
  for (const char* word : {"1d", "d0", "1d1d1", "1e1d1", "1d1e1", "dd"}) {
    EXPECT_NE(parse_real(word).fault, nullptr) << word;
  }
}

TEST(ParseReal, KnowsADecimalComma) {
  EXPECT_STREQ(parse_real("1,5").fault, "is not a number (a comma where a point should be)");
  EXPECT_STREQ(parse_real("1,5,0").fault, "is not a number");
}

TEST(ParseReal, RejectsWordsThatAreNotANumber) {
  for (const char* word : {"", "+", "-", "+-1", "++1", "abc", "1,5", "1.5x", "0x10", "1e", "--1"}) {
    EXPECT_NE(parse_real(word).fault, nullptr) << word;
  }
}

TEST(ParseReal, RejectsNanAndInfinity) {
  for (const char* word : {"nan", "-nan", "NaN", "nan(1)", "inf", "-inf", "infinity", "INF"}) {
    EXPECT_NE(parse_real(word).fault, nullptr) << word;
  }
}

TEST(ParseReal, TellsTooLargeFromTooSmall) {
  const std::string thousand_zeros(1000, '0');
  for (const std::string& word :
       {std::string("1e309"), std::string("-1e999"), "1" + thousand_zeros,
        std::string("1e99999999999999999999"), "0." + thousand_zeros + "1e9999"}) {
    EXPECT_NE(parse_real(word).fault, nullptr) << word;
  }
  for (const std::string& word :
       {std::string("1e-400"), std::string("-1e-999"), "0." + thousand_zeros + "1",
        std::string("1e-99999999999999999999"), "1" + thousand_zeros + "e-9999",
        std::string("0e999999")}) {
    EXPECT_EQ(parse_real(word).fault, nullptr) << word;
    EXPECT_EQ(parse_real(word).value, 0.0) << word;
  }
}

TEST(ParseReal, ReadsSubnormals) {
  EXPECT_EQ(parse_real("5e-324").value, 5e-324);
  EXPECT_EQ(parse_real("5e-324").fault, nullptr);
}

TEST(ParseInteger, ReadsWholeNumbersOnly) {
  EXPECT_EQ(parse_integer("+12").value, 12);
  EXPECT_EQ(parse_integer("-3").value, -3);
  for (const char* word : {"", "1.0", "1e3", "x", "1x", "99999999999999999999"}) {
    EXPECT_NE(parse_integer(word).fault, nullptr) << word;
  }
}

}  // namespace
}  // namespace spoctree
