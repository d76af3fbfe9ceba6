// Bytes of a text file into words, line by line, knowing at every moment the line number that an
// error message needs. All the text formats are read through it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "server/mesh/precision.hpp"

namespace spoctree {

/// What a number belongs to, for error messages: {"face", 10} prints as "face 10".
struct Item {
  const char* kind;
  std::uint64_t number;
};
std::string to_string(Item item);

/// `word` in single quotes, fit to be printed: cut after mesh_limits::kMaxQuotedBytes bytes, with
/// every byte that is not printable ASCII as \xNN.
std::string quoted(std::string_view word);

/// Walks over words separated by blanks (space, tab, CR, VT, FF); lines end with LF. A byte order
/// mark of UTF-8, with which some editors begin a file, is no part of the first word. Views handed
/// out point into `bytes`, which has to outlive the cursor. Linear in the size of the text.
class TextCursor {
 public:
  struct Syntax {
    char comment = '#';                  ///< starts a comment that ends with its line; '\0': none
    bool backslash_joins_lines = false;  /// OBJ: a backslash as the last byte of a line
    std::size_t first_line = 1;          ///< number of the line that `bytes` begins with
  };

  TextCursor(std::string_view bytes, std::string_view name) : TextCursor(bytes, name, Syntax()) {}
  TextCursor(std::string_view bytes, std::string_view name, Syntax syntax)
      : bytes_(bytes), name_(name), syntax_(syntax), line_(syntax.first_line) {
    if (line_ == 1 && bytes.starts_with(kByteOrderMark)) position_ = kByteOrderMark.size();
  }

  /// Leaves the rest of this line and goes to the first word of the next line that has one. False
  /// at the end of the text. The first call goes to the first line.
  bool next_line();

  /// The next word of this line; empty at its end.
  std::string_view next_word();

  /// The next word of this or a later line; empty at the end of the text.
  std::string_view next_word_of_any_line();

  /// The next word of this line as a finite number, or an error that names `item`.
  double read_real(Item item);

  /// The same for a coordinate along `axis`; how it is written goes to `record`.
  double read_coordinate(Item item, int axis, DigitRecord& record);

  /// The next word of this line as a whole number, or an error that names `item`.
  std::int64_t read_integer(Item item);

  /// Steps over the end of this line, which may hold nothing but blanks, and returns the offset of
  /// the byte after it. Nothing behind the line end is looked at. Throws BadInput.
  std::size_t step_over_line_end();

  std::size_t line() const { return line_; }

  /// Throws BadInput("name:line: what").
  [[noreturn]] void fail(const std::string& what) const { fail_at(line_, what); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& what) const;

 private:
  static constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

  void skip_blanks();
  bool skip_joined_line_end();
  double to_real(std::string_view word, Item item) const;

  std::string_view bytes_;
  std::string_view name_;
  Syntax syntax_;
  std::size_t position_ = 0;
  std::size_t line_;
  bool started_ = false;
};

}  // namespace spoctree
