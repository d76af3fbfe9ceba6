#include "common/program/progress_line.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

#include "common/base/temporary_name.hpp"

namespace spoctree {

namespace {
constexpr std::chrono::milliseconds kInterval{100};

// Carriage return, erase to the end of the line.
constexpr const char* kClear = "\r\x1b[K";

// A line that goes on in a second row could not be overwritten.
int columns_for_text() {
  winsize size{};
  const bool is_known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return is_known ? size.ws_col - 1 : 79;
}
}  // namespace

ProgressLine::ProgressLine() : is_terminal_(::isatty(STDERR_FILENO) == 1) {}

bool ProgressLine::wants_text() const {
  return is_terminal_ && std::chrono::steady_clock::now() >= next_;
}

void ProgressLine::show(const std::string& text) {
  if (!is_terminal_) return;
  next_ = std::chrono::steady_clock::now() + kInterval;
  if (!is_shown_) set_last_words(kClear);
  is_shown_ = true;
  // Carriage return, the text, erase to the end of the line.
  std::fprintf(stderr, "\r%.*s\x1b[K", columns_for_text(), text.c_str());
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (!is_shown_) return;
  is_shown_ = false;
  set_last_words(nullptr);
  std::fputs(kClear, stderr);
  std::fflush(stderr);
}

}  // namespace spoctree
