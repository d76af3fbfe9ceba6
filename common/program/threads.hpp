// How many threads a command may use.
#pragma once

#include <memory>

namespace CLI {
class App;
}

namespace spoctree {

/// While it lives, the process uses at most so many threads (the least of all limits that live).
/// Parallel code uses oneTBB's current arena and need not know of it. Results never depend on it.
class ThreadLimit {
 public:
  /// REQUIRES: threads >= 1.
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

/// The option `--threads N` of a command.
class ThreadsOption {
 public:
  /// Adds the option to a command. REQUIRES: this outlives the command's parsing.
  explicit ThreadsOption(CLI::App& command);
  ~ThreadsOption();
  ThreadsOption(const ThreadsOption&) = delete;
  ThreadsOption& operator=(const ThreadsOption&) = delete;

  /// Puts the limit in force until this is destroyed. Without the option: every core.
  void apply();

 private:
  int threads_ = 0;
  std::unique_ptr<ThreadLimit> limit_;
};

}  // namespace spoctree
