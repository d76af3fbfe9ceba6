// One line on the terminal that says how far a command is.
#pragma once

#include <chrono>
#include <string>

namespace spoctree {

/// Shows a line on standard error and overwrites it with the next; shows nothing where standard
/// error is not a terminal. The line is gone when this is destroyed, or a signal ends the program.
/// One at a time.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// True if a text shown now would be seen: there is a terminal, and the last one has had its
  /// time. Ask before making a text.
  bool wants_text() const;
  void show(const std::string& text);
  void clear();

 private:
  bool is_terminal_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace spoctree
