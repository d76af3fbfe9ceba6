// What Ctrl-C must not leave behind: temporary files, and half a line on the terminal.
#pragma once

#include <string>

namespace spoctree {

/// Holds the name of a temporary file while that file exists. Creates and removes nothing itself.
class TemporaryName {
 public:
  /// Remembers `path` for remove_temporary_files_on_signals. Paths that are too long or too many
  /// are not remembered: such a file then survives a signal, and nothing else happens.
  explicit TemporaryName(const std::string& path);
  ~TemporaryName();
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

 private:
  int slot_ = -1;
};

/// What is written to standard error before a signal ends the program: a literal, or nullptr for
/// nothing.
void set_last_words(const char* text);

/// From now on SIGINT, SIGTERM and SIGHUP first remove every file that a TemporaryName holds, and
/// write the last words; then they end the program as they always do.
void remove_temporary_files_on_signals();

}  // namespace spoctree
