#include "server/mesh/parse_text_stl.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "common/base/ascii_case.hpp"
#include "server/mesh/limits.hpp"
#include "server/mesh/point_table.hpp"
#include "server/mesh/text_cursor.hpp"

namespace spoctree {

namespace {

constexpr TextCursor::Syntax kSyntax{.comments = "#;"};

// The words of the format. None of them begins a line that could be skipped.
constexpr std::array<std::string_view, 10> kKeywords = {"facet",    "normal", "outer",    "loop",
                                                        "vertex",   "end",    "endfacet", "endloop",
                                                        "endsolid", "solid"};

bool is_keyword(std::string_view word) {
  return std::any_of(kKeywords.begin(), kKeywords.end(),
                     [word](std::string_view known) { return equals_in_any_case(word, known); });
}

// A name may be glued to the word.
bool begins_solid(std::string_view word) { return starts_in_any_case(word, "solid"); }
bool ends_solid(std::string_view word) { return starts_in_any_case(word, "endsolid"); }

// How far from the beginning the first solid or facet is looked for.
constexpr std::size_t kMaxPreambleBytes = 4096;

// Goes to the first line that begins with one, if there is such a line; how many lines, but for
// comments, are before it.
struct Preamble {
  bool has_end = false;
  std::size_t lines = 0;
};
Preamble skip_preamble(std::string_view bytes) {
  Preamble preamble;
  TextCursor cursor(bytes.substr(0, kMaxPreambleBytes), "", kSyntax);
  for (; cursor.next_line(); ++preamble.lines) {
    const std::string_view word = cursor.next_word();
    preamble.has_end = begins_solid(word) || equals_in_any_case(word, "facet");
    if (preamble.has_end) break;
  }
  return preamble;
}

class TextStlReader {
 public:
  TextStlReader(std::string_view bytes, std::string_view name)
      : cursor_(bytes, name, kSyntax), table_(soup_.points) {
    const std::size_t lines = skip_preamble(bytes).lines;
    for (std::size_t i = 0; i <= lines; ++i) cursor_.next_line();
    if (lines > 0) {
      soup_.remarks.push_back("ignored: " + std::to_string(lines) +
                              (lines == 1 ? " line" : " lines") + " before the first solid");
    }
  }

  PolygonSoup read() {
    for (std::string_view word = next_keyword(); !word.empty(); word = next_keyword()) {
      if (equals_in_any_case(word, "facet")) {
        if (!is_in_solid_) begin_without_solid(word);
        read_facet({"facet", facet_number()});
      } else if (begins_solid(word)) {
        begin_solid();
      } else if (is_in_solid_) {
        end_solid(word);
      } else {
        skip_rest(word);
      }
    }
    if (is_in_solid_) {
      if (facet_number() == 0) fail_expected("facet or endsolid", {});
      soup_.remarks.push_back("the file ends without endsolid, behind facet " +
                              std::to_string(facet_number() - 1) + " (counted from 0)");
    }
    if (facet_number() == 0) cursor_.fail("the file has no facets");
    soup_.precision = digits_.precision();
    return std::move(soup_);
  }

 private:
  std::size_t facet_number() const { return soup_.face_count() + soup_.collapsed.count; }

  // The next word that is no comment and no colour.
  std::string_view next_keyword() {
    std::string_view word = cursor_.next_word_of_any_line();
    while (!word.empty() && (word[0] == 'c' || word[0] == 'C' || word[0] == '/')) {
      if (word.starts_with("//")) {
        word = cursor_.next_line() ? cursor_.next_word() : std::string_view();
      } else if (equals_in_any_case(word, "color") || equals_in_any_case(word, "colour")) {
        do word = cursor_.next_word();
        while (!word.empty() && !is_keyword(word));
        if (word.empty()) word = cursor_.next_word_of_any_line();
      } else {
        break;
      }
    }
    return word;
  }

  [[noreturn]] void fail_expected(std::string_view keyword, std::string_view word) const {
    cursor_.fail("facet " + std::to_string(facet_number()) + ": expected " + std::string(keyword) +
                 ", found " + (word.empty() ? "the end of the file" : quoted(word)));
  }

  void expect(std::string_view keyword) {
    const std::string_view word = next_keyword();
    if (!equals_in_any_case(word, keyword)) fail_expected(keyword, word);
  }

  // "endloop" or "end loop", of which `word` is the first.
  void expect_end(std::string_view what, std::string_view word) {
    const std::string keyword = "end" + std::string(what);
    if (equals_in_any_case(word, keyword)) return;
    if (equals_in_any_case(word, "end")) {
      word = next_keyword();
      if (equals_in_any_case(word, what)) return;
    }
    fail_expected(keyword, word);
  }

  void begin_without_solid(std::string_view word) {
    if (facet_number() > 0 || has_solids_) fail_expected("solid", word);
    soup_.remarks.emplace_back("the file begins without solid");
    is_in_solid_ = true;
  }

  // Past the name, which may be anything and ends with its line; and past lines that are not of the
  // format, as long as there is no facet.
  void begin_solid() {
    is_in_solid_ = true;
    has_solids_ = true;
    cursor_.skip_line();
    if (facet_number() > 0) return;
    std::size_t lines = 0;
    for (; cursor_.next_line(); ++lines) {
      const std::string_view word = cursor_.peek_word();
      if (is_keyword(word) || ends_solid(word) || begins_solid(word)) break;
      if (starts_in_any_case(word, "colo") || word.starts_with("//")) break;
      cursor_.skip_line();
    }
    if (lines == 0) return;
    soup_.remarks.push_back("ignored: " + std::to_string(lines) +
                            (lines == 1 ? " line" : " lines") + " between solid and first facet");
  }

  void end_solid(std::string_view word) {
    if (!ends_solid(word)) {
      const bool is_end = equals_in_any_case(word, "end");
      if (is_end) word = next_keyword();
      if (!is_end || !begins_solid(word)) fail_expected("facet or endsolid", word);
    }
    is_in_solid_ = false;
    cursor_.skip_line();
  }

  // Behind the last solid. What has facets belongs to the solid, in some way.
  void skip_rest(std::string_view word) {
    if (facet_number() == 0) fail_expected("solid", word);
    const std::string_view rest = cursor_.rest();
    if (is_keyword(word) || contains_in_any_case(rest, "facet") ||
        contains_in_any_case(rest, "vertex")) {
      fail_expected("solid", word);
    }
    soup_.remarks.push_back("ignored: " + std::to_string(word.size() + rest.size()) +
                            " bytes behind the last solid");
    cursor_.skip_to_end();
  }

  // On whatever line it stands; but where a line ends and the next begins with a word of the
  // format, a number is missing.
  double read_coordinate(Item facet, int axis) {
    if (cursor_.is_at_line_end() && !is_keyword(cursor_.peek_word())) cursor_.go_to_next_word();
    return cursor_.read_coordinate(facet, axis, digits_);
  }

  void read_facet(Item facet) {
    std::string_view word = next_keyword();
    if (equals_in_any_case(word, "normal")) {
      // Normals follow from the corners. Many writers have "nan" here for thin facets.
      for (int axis = 0; axis < 3; ++axis) {
        if (cursor_.next_word().empty()) {
          cursor_.fail(to_string(facet) + ": the normal is cut short");
        }
      }
      word = next_keyword();
    } else if (!equals_in_any_case(word, "outer")) {
      fail_expected("normal", word);
    }
    if (!equals_in_any_case(word, "outer")) fail_expected("outer", word);
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      glm::dvec3 point;
      for (int axis = 0; axis < 3; ++axis) point[axis] = read_coordinate(facet, axis);
      soup_.corners.push_back(table_.find_or_add(point));
    }
    word = next_keyword();
    if (equals_in_any_case(word, "vertex")) {
      cursor_.fail(to_string(facet) + " has more than 3 corners");
    }
    expect_end("loop", word);
    expect_end("facet", next_keyword());
    if (soup_.points.size() > mesh_limits::kMaxPoints) {
      cursor_.fail("the file has more than " + std::to_string(mesh_limits::kMaxPoints) +
                   " vertices");
    }
    const std::string fault = close_face(soup_);
    if (!fault.empty()) cursor_.fail(to_string(facet) + " " + fault);
  }

  TextCursor cursor_;
  PolygonSoup soup_;
  DigitRecord digits_;
  PointTable table_;
  bool is_in_solid_ = false;
  bool has_solids_ = false;
};

}  // namespace

bool looks_like_text_stl(std::string_view bytes) {
  // The padding and the count of a binary header have NUL bytes, or else a first facet has.
  constexpr std::size_t kBytesOfHeaderAndFacet = 134;
  if (bytes.substr(0, kBytesOfHeaderAndFacet).find('\0') != std::string_view::npos) return false;
  return skip_preamble(bytes).has_end;
}

PolygonSoup parse_text_stl(std::string_view bytes, std::string_view name) {
  return TextStlReader(bytes, name).read();
}

}  // namespace spoctree
