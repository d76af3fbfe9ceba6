#include "client/draw/lettering.hpp"

namespace spoctree {

namespace {

constexpr double kGlyphHeight = 6;
constexpr double kGlyphWidth = 4;
constexpr double kAdvance = 6;

/// Points as two digits, x from 0 to 4 and y from 0 to 6; a blank lifts the pen.
constexpr const char* kCapitals[26] = {"002640 1333",
                                       "00063645443303 3342413000",
                                       "4536160501103041",
                                       "00062644422000",
                                       "46060040 0333",
                                       "460600 0333",
                                       "45361605011030414323",
                                       "0006 4046 0343",
                                       "1030 2026 1636",
                                       "4641301001",
                                       "0006 4602 1340",
                                       "060040",
                                       "0006234640",
                                       "00064046",
                                       "103041453616050110",
                                       "00063645443303",
                                       "103041453616050110 2240",
                                       "00063645443303 2340",
                                       "453616050413334241301001",
                                       "0646 2620",
                                       "060110304146",
                                       "062046",
                                       "0610233046",
                                       "0046 0640",
                                       "062346 2320",
                                       "06460040"};
constexpr const char* kDigits[10] = {
    "103041453616050110 0145",     "152620 1030", "05163645440040",
    "051636454433 13334241301001", "30360242",    "460603334241301001",
    "4536160501103041423303",      "064610",      "13040516364544331302011030414233",
    "0110304145361605041343"};

const char* glyph_of(char c) {
  if (c >= 'a' && c <= 'z') return kCapitals[c - 'a'];
  if (c >= 'A' && c <= 'Z') return kCapitals[c - 'A'];
  if (c >= '0' && c <= '9') return kDigits[c - '0'];
  switch (c) {
    case '-':
      return "1333";
    case '.':
      return "2021";
    case '/':
      return "0046";
    case ':':
      return "2122 2425";
    case ',':
      return "2110";
    default:
      return "";
  }
}

}  // namespace

std::vector<std::vector<Vec2>> letter(std::string_view text, Vec2 at, double height) {
  const double unit = height / kGlyphHeight;
  std::vector<std::vector<Vec2>> strokes;
  for (const char c : text) {
    bool is_down = false;
    for (const char* point = glyph_of(c); *point != '\0';) {
      if (*point == ' ') {
        is_down = false;
        ++point;
        continue;
      }
      if (!is_down) strokes.emplace_back();
      is_down = true;
      strokes.back().push_back(at + Vec2{(point[0] - '0') * unit, -(point[1] - '0') * unit});
      point += 2;
    }
    at.x += kAdvance * unit;
  }
  return strokes;
}

double lettering_width(std::string_view text, double height) {
  if (text.empty()) return 0;
  const double gaps = static_cast<double>(text.size() - 1) * kAdvance;
  return (gaps + kGlyphWidth) * height / kGlyphHeight;
}

}  // namespace spoctree
