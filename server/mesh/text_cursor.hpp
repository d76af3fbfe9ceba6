// Bytes of a text file into words, line by line, knowing at every moment the line number that an
// error message needs. All the text formats are read through it.
#pragma once

#include <array>
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

/// Walks over words separated by blanks (space, tab, VT, FF); lines end with LF, CR LF, or CR alone
/// as on old Macs. A byte order mark of UTF-8, with which some editors begin a file, is no part of
/// the first word. Views handed out point into `bytes`, which has to outlive the cursor. Linear in
/// the size of the text.
class TextCursor {
 public:
  struct Syntax {
    std::string_view comments = "#";     ///< each of them starts a comment that ends with its line
    bool backslash_joins_lines = false;  ///< OBJ: a backslash as the last byte of a line
    std::size_t first_line = 1;          ///< number of the line that `bytes` begins with
  };

  TextCursor(std::string_view bytes, std::string_view name) : TextCursor(bytes, name, Syntax()) {}
  TextCursor(std::string_view bytes, std::string_view name, const Syntax& syntax);

  /// Leaves the rest of this line and goes to the first word of the next line that has one. False
  /// at the end of the text. The first call goes to the first line.
  bool next_line();

  /// The next word of this line; empty at its end.
  std::string_view next_word();

  /// The next word of this or a later line; empty at the end of the text.
  std::string_view next_word_of_any_line();

  /// The same without going there.
  std::string_view peek_word() const;

  /// Goes to the end of this line, or of the text.
  void skip_line();
  void skip_to_end() { position_ = bytes_.size(); }

  /// Whether the next word stands behind a line end, or there is none.
  bool is_at_line_end();

  /// Goes to the line of the next word, where this one has no more: what is read then may stand on
  /// any line.
  void go_to_next_word();

  /// The next word of this line as a finite number, or an error that names `item`.
  double read_real(Item item);

  /// The same for a coordinate along `axis`; how it is written goes to `record`.
  double read_coordinate(Item item, int axis, DigitRecord& record);

  /// The next word of this line as a whole number, or an error that names `item`.
  std::int64_t read_integer(Item item);

  /// Steps over the end of this line, which may hold nothing but blanks, and returns the offset of
  /// the byte after it. Nothing behind the line end is looked at: a text whose first line ends with
  /// CR alone may go on with LF as its data. Throws BadInput.
  std::size_t step_over_line_end();

  /// What has not been read yet.
  std::string_view rest() const { return bytes_.substr(position_); }

  std::size_t line() const { return line_; }

  /// Throws BadInput("name:line: what").
  [[noreturn]] void fail(const std::string& what) const { fail_at(line_, what); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& what) const;

 private:
  static constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

  enum class Kind : std::uint8_t { Word, Blank, LineEnd, Comment, Backslash };

  Kind kind_at(std::size_t position) const {
    return kinds_[static_cast<unsigned char>(bytes_[position])];
  }
  void step_over_one_line_end();
  void skip_blanks();
  bool skip_joined_line_end();
  double to_real(std::string_view word, Item item) const;

  std::string_view bytes_;
  std::string_view name_;
  std::array<Kind, 256> kinds_{};  // of every byte
  bool joins_lines_;
  std::size_t position_ = 0;
  std::size_t line_;
  bool started_ = false;
};

}  // namespace spoctree
