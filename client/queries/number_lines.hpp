// Lines of numbers from a file or a pipe, one question each, of any number: nothing is held but the
// lines at hand.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace spoctree {

inline constexpr std::size_t kMaxQuestionBytes = 4'096;
inline constexpr std::size_t kMaxNumbersPerLine = 6;

/// Text in pieces of any size -> lines of numbers.
class NumberLines {
 public:
  /// Called with a line's number, counted from 1, and the numbers in it.
  using OnLine = std::function<void(std::uint64_t line, std::span<const double> numbers)>;

  /// Every line holds `per_line` (at most kMaxNumbersPerLine) finite numbers with blanks or tabs
  /// between. Lines without any, and those whose first character is '#', are passed over. `name` is
  /// what errors call the source.
  NumberLines(std::string name, std::size_t per_line, OnLine on_line);

  /// The next piece. Throws BadInput, naming the line, where a line is something else or longer
  /// than kMaxQuestionBytes; all lines before it have been handed over then.
  void feed(std::string_view text);
  /// The text has ended: the last line need not have a line end.
  void finish();

 private:
  void read_line(std::string_view line);
  [[noreturn]] void refuse(const std::string& what) const;

  std::string name_;
  std::size_t per_line_;
  OnLine on_line_;
  std::string begun_;  ///< a line whose end has not come yet
  std::uint64_t line_ = 0;
};

/// Feeds `lines` with a file ("-": standard input) as it comes, and calls `flush` whenever it has
/// to wait for more: who asks one question at a time gets one answer at a time. Throws BadInput
/// when the file cannot be read, and what `lines` throws, after one last `flush`.
void read_questions(const std::string& path, NumberLines& lines,
                    const std::function<void()>& flush);

/// What errors call a file of questions.
std::string name_of_questions(const std::string& path);

}  // namespace spoctree
