#include "client/queries/number_lines.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "common/base/errors.hpp"
#include "common/base/parse_number.hpp"
#include "common/wire/text.hpp"

namespace spoctree {

namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::size_t kMaxQuotedBytes = 40;

/// An open file, closed at the end if it is ours.
class Input {
 public:
  explicit Input(const std::string& path) : name_(name_of_questions(path)) {
    if (path == "-") return;
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail();
  }
  ~Input() {
    if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  /// Empty at the end.
  std::string_view read() {
    while (true) {
      const ssize_t count = ::read(descriptor_, buffer_.data(), buffer_.size());
      if (count >= 0) return {buffer_.data(), static_cast<std::size_t>(count)};
      if (errno != EINTR) fail();
    }
  }

 private:
  [[noreturn]] void fail() const {
    throw BadInput(name_ + ": cannot read: " + std::strerror(errno));
  }

  std::string name_;
  int descriptor_ = STDIN_FILENO;
  std::array<char, 65'536> buffer_;
};

}  // namespace

std::string name_of_questions(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

NumberLines::NumberLines(std::string name, std::size_t per_line, OnLine on_line)
    : name_(std::move(name)), per_line_(per_line), on_line_(std::move(on_line)) {}

void NumberLines::refuse(const std::string& what) const {
  throw BadInput(name_ + ": line " + std::to_string(line_) + ": " + what);
}

void NumberLines::feed(std::string_view text) {
  while (true) {
    const std::size_t end = text.find('\n');
    const std::string_view part = text.substr(0, end);
    if (begun_.size() + part.size() > kMaxQuestionBytes) {
      ++line_;
      refuse("longer than " + std::to_string(kMaxQuestionBytes) + " bytes");
    }
    if (end == std::string_view::npos) {
      begun_ += part;
      return;
    }
    if (begun_.empty()) {
      read_line(part);
    } else {
      begun_ += part;
      read_line(begun_);
      begun_.clear();
    }
    text.remove_prefix(end + 1);
  }
}

void NumberLines::finish() {
  if (!begun_.empty()) read_line(std::exchange(begun_, {}));
}

void NumberLines::read_line(std::string_view line) {
  ++line_;
  if (line.starts_with('#')) return;
  std::array<double, kMaxNumbersPerLine> numbers;
  std::size_t count = 0;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    if (line.empty()) break;
    const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
    line.remove_prefix(word.size());
    const ParsedReal parsed = parse_real(word);
    if (parsed.fault != nullptr) {
      refuse("'" + clean_text(word, kMaxQuotedBytes) + "' " + parsed.fault);
    }
    if (count < per_line_) numbers[count] = parsed.value;
    ++count;
  }
  if (count == 0) return;
  if (count != per_line_) {
    refuse(std::to_string(count) + (count == 1 ? " number" : " numbers") + " where " +
           std::to_string(per_line_) + " belong");
  }
  on_line_(line_, {numbers.data(), per_line_});
}

void read_questions(const std::string& path, NumberLines& lines,
                    const std::function<void()>& flush) {
  Input input(path);
  try {
    while (true) {
      const std::string_view text = input.read();
      if (text.empty()) break;
      lines.feed(text);
      flush();
    }
    lines.finish();
  } catch (const BadInput&) {
    flush();
    throw;
  }
  flush();
}

}  // namespace spoctree
