// How many threads a command may use.
#pragma once

#include <memory>

namespace CLI {
class App;
}

namespace spoctree {

/// The option `--threads N` of a command. Parallel code uses oneTBB's current arena and need not
/// know of it: the number is a limit for the whole process. Results never depend on it.
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
  struct Limit;
  int threads_ = 0;
  std::unique_ptr<Limit> limit_;
};

}  // namespace spoctree
