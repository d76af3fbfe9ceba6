// Running a program as its user does who sits at a terminal.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

#include "tests/end_to_end/programs.hpp"

namespace spoctree::test {

/// A program under way whose input, output and errors are a terminal of 80 columns. A limit of two
/// minutes ends what does not end by itself.
class TerminalProgram {
 public:
  TerminalProgram(const std::string& program, const Arguments& arguments);
  /// Kills it if it still runs.
  ~TerminalProgram();
  TerminalProgram(const TerminalProgram&) = delete;
  TerminalProgram& operator=(const TerminalProgram&) = delete;

  /// Reads what the program shows until `is_there` says so of all of it; false if the program ends
  /// before that, or after a minute.
  bool wait_for(const std::function<bool(const std::string& shown)>& is_there);
  bool wait_for(const std::string& text);
  /// Types Ctrl-C: the terminal makes a signal of it.
  void press_ctrl_c();
  void send(int signal) const;
  /// Reads on until the program ends. As Outcome::code.
  int wait();
  /// Everything it has shown, control characters included.
  const std::string& shown() const { return shown_; }

 private:
  bool read_some();

  pid_t pid_ = -1;
  int terminal_ = -1;
  std::string shown_;
};

}  // namespace spoctree::test
